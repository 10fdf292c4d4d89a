/// A scene that is hard for bundles of eight, in addition to the piles of earlier chapters.
#pragma once

#include "pushback/common/world/world.h"

namespace pushback::wide_scenes {

/// A slab on the ground that carries a square of boxes and forms a pair with each of them.
struct LoadedSlab {
  int boxes = 10;  ///< along each side

  void operator()(World& world) const {
    const Real half = Real(0.6) * static_cast<Real>(boxes);
    world.add(ground());
    world.add(box({half, Real(0.25), half}, 1000).at({0, Real(0.25), 0}));
    for (int i = 0; i < boxes * boxes; ++i) {
      const auto from_middle = [&](int place) {
        return Real(1.2) * (static_cast<Real>(place) - static_cast<Real>(boxes - 1) / 2);
      };
      world.add(box(Vec3::Constant(Real(0.4)), 20).at({from_middle(i % boxes), Real(0.9), from_middle(i / boxes)}));
    }
  }
};

}  // namespace pushback::wide_scenes
