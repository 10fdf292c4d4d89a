/// How a world looks: its bodies, its contact points by what the solver did, its impulses as arrows.
#pragma once

#include <functional>
#include <optional>

#include "pushback/common/render/picture.h"
#include "pushback/common/world/world.h"

namespace pushback {

/// `arrow`: metres to draw for an impulse of 1 N s; without it, contacts are not drawn at all. Arrows longer than 1.5 times the
/// body's size are cut to it, and those that would be lost under their contact's dot are left out. Dots and shafts have one
/// size on the picture, wherever they are, unless that were large beside a typical body.
Picture picture_of(const World& world, const Camera& camera, std::optional<Real> arrow);

/// Adds what moves in another world, with its joints, contacts, arrows and `marks`, all of it moved by `shift`, m.
void add_moving(Picture& picture, const World& world, std::optional<Real> arrow, const Vec3& shift,
                const std::function<void(Picture&, const World&)>& marks = {});

/// The world, each movable body displaced and turned `times` as far from where it is in `start` as it is. Contact points
/// move with the body A that they lie on, or with B where A cannot move.
World magnified(const World& world, const World& start, Real times);

/// Metres for 1 N s such that the impulse which holds an average body against gravity for `dt` seconds is drawn about
/// as long as that body; where there is no gravity, such that it fits a speed of 1 m/s.
Real fitting_arrow(const World& world, Real dt);

}  // namespace pushback
