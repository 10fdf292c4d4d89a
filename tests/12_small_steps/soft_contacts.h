/// What the tests of soft contacts share: a ball in the ground, and a pair that is free.
#pragma once

#include "pushback/chapters/12_small_steps/small_steps.h"
#include "pushback/common/world/measure.h"
#include "pushback/common/world/situations.h"
#include "tests/support/catch.h"
#include "tests/support/random.h"

namespace pushback {

inline constexpr Real eps = std::numeric_limits<Real>::epsilon();
inline constexpr Real g = Real(9.81);
inline constexpr Real h = Real(1) / 60;
inline constexpr bool is_double = std::numeric_limits<Real>::digits > 24;

/// The springs without the pass that takes their push back.
template <class... Effects>
struct Unrelaxed : RelaxingSolver<Effects...> {
  void after_move(World&, Real) {}
};

/// A ball of `mass` kg that is `depth` deep in the ground: one contact, K = 1/m.
inline Body& ball_on_ground(World& world, Real depth, Real mass = 10) {
  world.add(ground());
  world.add(sphere(Real(0.3), mass).at({0, Real(0.3) - depth, 0}));
  return world.bodies[1];
}

/// Two boxes that overlap and turn, and nothing else: free.
inline void overlapping_pair(World& world, Random& random) {
  world.gravity.setZero();
  for (const int side : {-1, 1}) {
    const Vec3 spin = random.vector(1);
    world.add(box(Vec3::Constant(Real(0.5)), random.over_decades(1, 100))
                  .at({static_cast<Real>(side) * Real(0.46), 0, 0})
                  .spinning(spin));
  }
}

}  // namespace pushback
