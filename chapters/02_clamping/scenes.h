/// Scenes with a column that lands flat, a column that rotates as it lands, and a stack of three columns.
#pragma once

#include "pushback/common/world/situations.h"

namespace pushback::clamping_scenes {

/// A column that lands flat on four points at once. Compared with its height, they are so close together that an impulse at one of
/// them affects the others.
struct LandingColumn {
  Real fall = Real(0.5);  ///< m

  void operator()(World& world) const {
    world.add(ground());
    world.add(box({Real(0.25), Real(0.8), Real(0.25)}, 100).at({0, Real(0.8) + fall, 0}));
  }
};

/// The column that lands flat next to a column that rotates as it lands, so that one edge arrives while the other leaves.
struct TwoLandings {
  LandingColumn flat;

  static constexpr Real aside = Real(0.8);  ///< m, of each column from the middle

  void operator()(World& world) const {
    flat(world);
    world.bodies.back().at({-aside, world.bodies.back().position.y(), 0}).coloured(2);
    world.add(box({Real(0.25), Real(0.8), Real(0.25)}, 100)
                  .at({aside, Real(0.799), 0})
                  .moving({0, -1, 0})
                  .spinning({0, 0, -6})
                  .coloured(4));
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
