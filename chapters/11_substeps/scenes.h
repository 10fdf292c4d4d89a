/// Scenes that need many sweeps because a heavy body lies on a light one. The stacks are in common/world.
#pragma once

#include "pushback/common/world/situations.h"

namespace pushback::substeps_scenes {

struct HeavyOnLight {
  Real mass_ratio = 1000;  ///< mass of the upper box, in masses of the lower one

  void operator()(World& world) const {
    const Vec3 cube = Vec3::Constant(Real(0.5));  // half of 1 m
    world.add(ground());
    world.add(box(cube, 100).at({0, Real(0.5), 0}));
    world.add(box(cube, 100 * mass_ratio).at({0, Real(1.5), 0}));
  }
};

}  // namespace pushback::substeps_scenes
