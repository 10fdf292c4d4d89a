/// What is too deep: a box in the ground, with gravity and without.
#pragma once

#include "pushback/common/world/situations.h"

namespace pushback {

inline constexpr Real d0 = Real(0.06);  // m, overlap at the start

inline void sunken_box(World& world) {
  slab(world);
  world.add(box(Vec3::Constant(Real(0.5)), 100).at({0, Real(0.5) - d0, 0}).coloured(0));
}

inline void sunken_box_without_gravity(World& world) {
  world.gravity.setZero();
  sunken_box(world);
}

}  // namespace pushback
