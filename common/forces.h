/// Applied forces, to be put into World::forces: world.forces.push_back(spring(body, anchor, 40)).
#pragma once

#include "common/input.h"
#include "common/world.h"

namespace pushback {

/// F = -k (x - anchor), on the centre of mass. `stiffness` k in N/m, 0 or more.
inline auto spring(int body, const Vec3& anchor, Real stiffness) {
  require_finite("anchor of a spring", anchor);
  require_not_negative("stiffness of a spring", stiffness);
  return [=](World& world) {
    Body& b = world.bodies.at(static_cast<std::size_t>(body));
    b.force -= stiffness * (b.position - anchor);
  };
}

/// F = -c v. `coefficient` c in N s/m, 0 or more.
inline auto drag(int body, Real coefficient) {
  require_not_negative("drag", coefficient);
  return [=](World& world) {
    Body& b = world.bodies.at(static_cast<std::size_t>(body));
    b.force -= coefficient * b.velocity;
  };
}

}  // namespace pushback
