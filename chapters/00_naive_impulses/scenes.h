/// What gets its impulse: a ball that hits a box in empty space. The boxes on the ground are `stack`, of common/world.
#pragma once

#include "pushback/common/world/situations.h"

namespace pushback::naive_impulses_scenes {

struct SparseHit {
  Real speed = 4;               ///< m/s, of the ball
  Real mass_ratio = Real(0.6);  ///< of the ball, in masses of the box

  void operator()(World& world) const {
    world.gravity.setZero();
    world.add(box({Real(0.9), Real(0.3), Real(0.3)}, 100).at({0, 1, 0}).bouncy(1));
    world.add(sphere(Real(0.35), 100 * mass_ratio).at({Real(-2.6), Real(1.2), 0}).moving({speed, 0, 0}).bouncy(1));
  }
};

}  // namespace pushback::naive_impulses_scenes
