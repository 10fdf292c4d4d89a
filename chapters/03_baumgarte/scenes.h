/// What is too deep: a box in the ground, with gravity and without.
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

}  // namespace pushback::baumgarte_scenes
