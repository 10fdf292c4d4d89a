/// What flickers: a small pile.
#pragma once

#include "pushback/common/world/situations.h"

namespace pushback {

/// Three boxes on each other, the upper ones turned a little so that every point counts. Each starts 8 mm deep in what it
/// lies on: more than one slop, less than another.
inline void small_pile(World& world) {
  constexpr Real high = Real(0.592);  // 0.6 m less the overlap
  world.add(ground());
  world.add(box({Real(0.9), Real(0.3), Real(0.6)}, 100).at({0, Real(0.292), 0}));
  world.add(
      box({Real(0.7), Real(0.3), Real(0.5)}, 80).turned(Real(0.35), Vec3::UnitY()).at({0, Real(0.292) + high, 0}));
  world.add(
      box({Real(0.5), Real(0.3), Real(0.4)}, 60).turned(Real(-0.25), Vec3::UnitY()).at({0, Real(0.292) + 2 * high, 0}));
}

}  // namespace pushback
