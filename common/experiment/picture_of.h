/// How a world looks: its bodies, its contact points by what the solver did, its impulses as arrows.
#pragma once

#include "pushback/common/render/picture.h"
#include "pushback/common/world/world.h"

namespace pushback {

/// `arrow`: metres to draw for an impulse of 1 N s; arrows longer than 1.5 times the body's size are cut to it.
Picture picture_of(const World& world, const Camera& camera, Real arrow);

/// Metres for 1 N s such that the impulse which holds an average body against gravity for `dt` seconds is drawn about
/// as long as that body; where there is no gravity, such that it fits a speed of 1 m/s.
Real fitting_arrow(const World& world, Real dt);

}  // namespace pushback
