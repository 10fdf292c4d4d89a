/// What a row holds: a box that falls, one that is thrown upwards, a reader's cube on a slope.
#pragma once

#include "pushback/common/world/situations.h"

namespace pushback {

inline void dropped_box(World& world) {
  slab(world);
  world.add(box(Vec3::Constant(Real(0.5)), 100).at({0, Real(1.54), 0}).coloured(0));
}

inline void leaving_box(World& world) {
  slab(world);
  world.add(box(Vec3::Constant(Real(0.5)), 100).at({0, Real(0.49), 0}).moving({0, 5, 0}).coloured(0));
}

inline constexpr Real cube_slope = Real(0.35);  // rad

inline void cube_on_slope(World& world) {
  incline(world, cube_slope);
  const Vec3 up{-std::sin(cube_slope), std::cos(cube_slope), 0};
  world.add(box(Vec3::Constant(Real(0.5)), 100).turned(cube_slope, Vec3::UnitZ()).at(Real(0.499) * up));
}

}  // namespace pushback
