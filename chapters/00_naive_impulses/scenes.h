/// What gets its impulse: a ball that hits a box in empty space. The boxes on the ground are `stack`, of common/world.
#pragma once

#include "pushback/common/world/situations.h"

namespace pushback {

inline void sparse_hit(World& world) {
  world.gravity.setZero();
  world.add(box({Real(0.9), Real(0.3), Real(0.3)}, 100).at({0, 1, 0}).bouncy(1));
  world.add(sphere(Real(0.35), 60).at({Real(-2.6), Real(1.2), 0}).moving({4, 0, 0}).bouncy(1));
}

}  // namespace pushback
