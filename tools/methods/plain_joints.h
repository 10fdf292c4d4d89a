/// Which joints the position methods hold.
#pragma once

#include <cmath>

#include "pushback/common/basics/input.h"
#include "pushback/common/world/world.h"

namespace pushback {

/// Throws InvalidInput, with the joint's name, unless each equation of each joint is C(x) = 0 and no more: a wanted speed, softness
/// and bounds are for velocities. `method`: who says so. Of a step of h, s.
inline void check_plain_joints(const World& world, Real h, const std::string& method) {
  Equations equations;
  for (const Joint& joint : world.joints) {
    equations.clear();
    joint.ask(world.body(joint.a), world.body(joint.b), {world.time, h}, equations);
    for (const Equation& one : equations)
      if (one.bias != 0 || one.softness != 0 || std::isfinite(one.lo) || std::isfinite(one.hi))
        throw InvalidInput(
            fmt::format("{} is a joint with a speed, softness or bounds of its own: {} holds joints of C(x) = 0 alone",
                        joint.name, method));
  }
}

}  // namespace pushback
