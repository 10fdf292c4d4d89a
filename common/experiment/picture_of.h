/// Draws a world: its bodies, its contact points coloured by their state, its impulses as arrows.
#pragma once

#include <functional>
#include <optional>

#include "pushback/common/render/picture.h"
#include "pushback/common/world/world.h"

namespace pushback {

/// `arrow`: length in m for an impulse of 1 N s. Without it, contacts are not drawn. Arrows are at most 1.5 times as long as a
/// typical body, and arrows that their contact's dot would hide are omitted. Dots and shafts have the same size on the picture at
/// any distance, unless that size is large compared with a typical body.
Picture picture_of(const World& world, const Camera& camera, std::optional<Real> arrow);

/// Adds the movable bodies of another world with its joints, contacts, arrows and `marks`, all displaced by `shift` (m).
void add_moving(Picture& picture, const World& world, std::optional<Real> arrow, const Vec3& shift,
                const std::function<void(Picture&, const World&)>& marks = {});

/// A copy of the world in which the displacement and the rotation of each movable body since `start` are multiplied by `times`.
/// Contact points move with body A, or with body B if A cannot move.
World magnified(const World& world, const World& start, Real times);

/// The arrow length for 1 N s, m, which draws the impulse that holds an average body against gravity for `dt` s about as long as
/// that body. Without gravity, the length fits the impulse that gives the body a speed of 1 m/s.
Real fitting_arrow(const World& world, Real dt);

}  // namespace pushback
