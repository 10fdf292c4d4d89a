/// The pile that benchmarks have in common.
#pragma once

#include "pushback/common/world/world.h"

namespace pushback {

/// n x n columns of `high` boxes, each turned a little, which fall into a pile.
inline void pile(World& world, int n, int high) {
  world.add(ground());
  for (int i = 0; i < n * n * high; ++i) {
    const Vec3 place{static_cast<Real>(i % n) - static_cast<Real>(n) / 2,
                     Real(0.6) + static_cast<Real>(i / (n * n)) * Real(1.1),
                     static_cast<Real>(i / n % n) - static_cast<Real>(n) / 2};
    world.add(box({Real(0.4), Real(0.3), Real(0.45)}, 100)
                  .turned(static_cast<Real>(i % 7) * Real(0.2), Vec3(1, 2, 3))
                  .at(place));
  }
}

}  // namespace pushback
