/// A ball that hits a bar in empty space. The boxes on the ground are `stack` of common/world.
#pragma once

#include "pushback/common/world/situations.h"

namespace pushback::naive_impulses_scenes {

struct SparseHit {
  Real speed = 4;               ///< m/s, of the ball
  Real mass_ratio = Real(0.6);  ///< mass of the ball, in masses of the box

  void operator()(World& world) const {
    world.gravity.setZero();
    world.add(box({Real(0.9), Real(0.3), Real(0.3)}, 100).at({0, 1, 0}).bouncy(1));
    world.add(sphere(Real(0.35), 100 * mass_ratio).at({Real(-2.6), Real(1.2), 0}).moving({speed, 0, 0}).bouncy(1));
  }
};

/// A spinning bar, and a ball that comes from below and hits it off its centre when the bar is level. The bar yields so much that
/// the ball should stop.
struct SpinningHit {
  Real speed = 4;               ///< m/s, of the ball
  Real mass_ratio = Real(0.2);  ///< mass of the ball, in masses of the bar
  Real spin = Real(1.5);        ///< rad/s, of the bar

  static constexpr Real before = Real(0.2);  ///< s, from the start to the hit

  void operator()(World& world) const {
    world.gravity.setZero();
    const Real half = Real(0.2), radius = Real(0.25), deep = Real(0.001);
    world.add(box({1, half, Real(0.3)}, 100)
                  .turned(-spin * before, Vec3::UnitZ())
                  .spinning({0, 0, spin})
                  .bouncy(1)
                  .coloured(0));
    world.add(sphere(radius, 100 * mass_ratio)
                  .at({Real(0.7), deep - half - radius - speed * before, 0})
                  .moving({0, speed, 0})
                  .bouncy(1)
                  .coloured(3));
  }
};

}  // namespace pushback::naive_impulses_scenes
