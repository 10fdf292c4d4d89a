/// A box that is too deep in the ground, with and without gravity.
#pragma once

#include "pushback/common/world/situations.h"

namespace pushback::baumgarte_scenes {

struct SunkenBox {
  Real depth = Real(0.06);  ///< m, overlap at the start
  bool weightless = false;

  void operator()(World& world) const {
    if (weightless) world.gravity.setZero();
    slab(world);
    world.add(box(Vec3::Constant(Real(0.5)), 100).at({0, Real(0.5) - depth, 0}).coloured(0));
  }
};

/// The same with a box of 0.4 m, whose overlap and jump fit into one picture.
struct SunkenSmallBox {
  Real depth = SunkenBox{}.depth;  ///< m

  static constexpr Real half = Real(0.2);  ///< m

  void operator()(World& world) const {
    world.add(box({8, half, Real(0.95) * half}, 1).fixed().at({0, -half, 0}));
    world.add(box(Vec3::Constant(half), 100).at({0, half - depth, 0}).coloured(0));
  }
};

}  // namespace pushback::baumgarte_scenes
