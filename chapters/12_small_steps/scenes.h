/// What takes many sweeps: a tall stack, heavy on light; and a ball that is too deep.
#pragma once

#include "pushback/common/world/situations.h"

namespace pushback {

inline constexpr int tall = 20;             // boxes in the stack
inline constexpr Real heavy = 1000;         // times the mass of the box below
inline constexpr Real sunken = Real(0.05);  // m

/// Two posts behind it, to see by how much it leans.
inline void stack_of_twenty(World& world) {
  for (const int side : {-1, 1})
    world.add(box({Real(0.04), tall, Real(0.04)}, 1).fixed().at({static_cast<Real>(side) * Real(0.66), 0, -2}));
  stack(world, tall);
}

inline void heavy_on_light(World& world) {
  const Vec3 cube = Vec3::Constant(Real(0.5));  // half of 1 m
  world.add(ground());
  world.add(box(cube, 100).at({0, Real(0.5), 0}));
  world.add(box(cube, 100 * heavy).at({0, Real(1.5), 0}));
}

inline void sunken_ball(World& world) {
  world.gravity.setZero();
  world.add(ground());
  world.add(sphere(Real(0.5), 100).at({0, Real(0.5) - sunken, 0}));
}

}  // namespace pushback
