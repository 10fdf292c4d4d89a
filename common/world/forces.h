/// Applied forces for World::forces: world.forces.push_back(spring(body, anchor, 40)).
///
/// `body`: index in World::bodies. Each throws InvalidInput if a number is not finite, or a coefficient below 0.
#pragma once

#include "pushback/common/basics/input.h"
#include "pushback/common/world/world.h"

namespace pushback {

/// F = -k (x - anchor), on the centre of mass. `anchor`: m, world axes. `stiffness`: k, N/m, 0 or more.
inline Force spring(int body, const Vec3& anchor, Real stiffness) {
  require_finite("anchor of a spring", anchor);
  require_not_negative("stiffness of a spring", stiffness);
  const auto pull = [=](World& world) {
    Body& b = world.bodies.at(static_cast<std::size_t>(body));
    b.force -= stiffness * (b.position - anchor);
  };
  return {pull, "a spring", {body}};
}

/// F = -c v. `coefficient`: c, N s/m, 0 or more.
inline Force drag(int body, Real coefficient) {
  require_not_negative("drag", coefficient);
  const auto brake = [=](World& world) {
    Body& b = world.bodies.at(static_cast<std::size_t>(body));
    b.force -= coefficient * b.velocity;
  };
  return {brake, "drag", {body}};
}

}  // namespace pushback
