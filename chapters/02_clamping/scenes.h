/// What lands: a column, and three on each other.
#pragma once

#include "pushback/common/world/situations.h"

namespace pushback {

/// A column that lands flat: four points at once, close together for its height, so that an impulse at one of them is
/// felt by the others.
inline void landing_column(World& world) {
  constexpr Real fall = Real(0.5);  // m
  world.add(ground());
  world.add(box({Real(0.25), Real(0.8), Real(0.25)}, 100).at({0, Real(0.8) + fall, 0}));
}

inline void three_columns(World& world) {
  world.add(ground());
  for (int i = 0; i < 3; ++i)
    world.add(box({Real(0.3), Real(0.6), Real(0.3)}, 100)
                  .at({0, Real(0.6) + static_cast<Real>(i) * Real(1.25) + Real(0.1), 0}));
}

}  // namespace pushback
