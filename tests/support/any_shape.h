/// A body of any shape, about a metre large, in any orientation; one in four is a hull.
#pragma once

#include "pushback/common/bodies/random.h"

namespace pushback {

inline Body any_shape(Random& random) {
  if (random.below(4) > 0) return random.body(1);
  std::vector<Vec3> points;
  for (int i = 0; i < 8; ++i) points.push_back(random.direction());
  return hull(points, 1);
}

}  // namespace pushback
