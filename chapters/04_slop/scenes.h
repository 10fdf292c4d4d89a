/// A small pile whose contacts flicker.
#pragma once

#include "pushback/common/world/situations.h"

namespace pushback::slop_scenes {

/// Three boxes on each other, the upper ones rotated a little so that every point matters.
struct SmallPile {
  Real depth = Real(0.008);  ///< m, initial overlap of each box with its support, more than one slop, less than another

  void operator()(World& world) const {
    const Real lowest = Real(0.3) - depth, high = Real(0.6) - depth;
    world.add(ground());
    world.add(box({Real(0.9), Real(0.3), Real(0.6)}, 100).at({0, lowest, 0}));
    world.add(box({Real(0.7), Real(0.3), Real(0.5)}, 80).turned(Real(0.35), Vec3::UnitY()).at({0, lowest + high, 0}));
    world.add(
        box({Real(0.5), Real(0.3), Real(0.4)}, 60).turned(Real(-0.25), Vec3::UnitY()).at({0, lowest + 2 * high, 0}));
  }
};

}  // namespace pushback::slop_scenes
