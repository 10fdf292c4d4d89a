/// What is too deep: a box in the ground, boxes in each other, a ball; and a stack that sinks a little in every step.
#pragma once

#include "pushback/common/world/situations.h"

namespace pushback {

inline constexpr Real very_deep = Real(0.25);  // m, of 1 m
inline constexpr Real deep = Real(0.06);       // m

inline void very_deep_box(World& world) {
  slab(world);
  world.add(box(Vec3::Constant(Real(0.5)), 100).at({0, Real(0.5) - very_deep, 0}).coloured(0));
}

/// Twelve boxes of 1 m, two by three by two of them, 0.7 m from each other.
inline void boxes_in_each_other(World& world) {
  constexpr Real apart = Real(0.7);
  world.add(ground());
  for (int row = 0; row < 3; ++row) {
    for (const int side : {-1, 1}) {
      for (const int behind : {-1, 1}) {
        world.add(box(Vec3::Constant(Real(0.5)), 100)
                      .at({static_cast<Real>(side) * apart / 2, Real(0.5) + static_cast<Real>(row) * apart,
                           static_cast<Real>(behind) * apart / 2}));
      }
    }
  }
}

/// Two posts behind it, to see by how much it leans.
inline void stack_of_ten(World& world) {
  for (const int side : {-1, 1})
    world.add(box({Real(0.04), 10, Real(0.04)}, 1).fixed().at({static_cast<Real>(side) * Real(0.66), 0, -2}));
  stack(world, 10);
}

inline void weightless_ball(World& world) {
  world.gravity.setZero();
  world.add(ground());
  world.add(sphere(Real(0.5), 100).at({0, Real(0.5) - deep, 0}));
}

/// A ball 1 m above the ground.
inline std::function<void(World&)> dropped_ball(Real e) {
  return [e](World& world) {
    world.add(ground());
    world.add(sphere(Real(0.3), 10).at({0, Real(1.3), 0}).bouncy(e));
  };
}

}  // namespace pushback
