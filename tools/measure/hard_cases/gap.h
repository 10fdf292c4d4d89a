/// How far apart a joint's points are.
#pragma once

#include <cmath>

#include "pushback/common/world/world.h"
#include "pushback/tools/measure/hard_cases/standing.h"

namespace pushback {

/// m, of points that a joint holds on each other.
inline Real gap_of(const World& world, const Joint& joint) {
  Equations equations;
  joint.ask(body_of(world, joint.a), body_of(world, joint.b), {world.time, frame}, equations);
  Real squared = 0;
  for (const Equation& equation : equations)
    squared += equation.jacobian.n.isZero(0) ? 0 : equation.error * equation.error;
  return std::sqrt(squared);
}

}  // namespace pushback
