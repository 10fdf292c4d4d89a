/// What lands: a column, and three on each other.
#pragma once

#include "pushback/common/world/situations.h"

namespace pushback::clamping_scenes {

/// A column that lands flat: four points at once, close together for its height, so that an impulse at one of them is
/// felt by the others.
struct LandingColumn {
  Real fall = Real(0.5);  ///< m

  void operator()(World& world) const {
    world.add(ground());
    world.add(box({Real(0.25), Real(0.8), Real(0.25)}, 100).at({0, Real(0.8) + fall, 0}));
  }
};

struct StackedColumns {
  int count = 3;

  void operator()(World& world) const {
    world.add(ground());
    for (int i = 0; i < count; ++i)
      world.add(box({Real(0.3), Real(0.6), Real(0.3)}, 100)
                    .at({0, Real(0.6) + static_cast<Real>(i) * Real(1.25) + Real(0.1), 0}));
  }
};

}  // namespace pushback::clamping_scenes
