/// A heap that falls, from a start of its own.
#pragma once

#include "pushback/common/bodies/random.h"
#include "pushback/common/world/situations.h"

namespace pushback::to_each_its_own_tests {

/// 64 boxes that fall into a heap.
inline World falling_heap(std::uint64_t start = 7) {
  World world;
  world.add(ground());
  Random random(start);
  for (int i = 0; i < 64; ++i) {
    const Vec3 at{Real(i % 4) * Real(0.75), Real(0.5) + Real(i / 16) * Real(0.75), Real(i / 4 % 4) * Real(0.75)};
    world.add(box(Vec3::Constant(Real(0.2)), 10).at(at + random.vector(Real(0.1))).oriented(random.orientation()));
  }
  return world;
}

}  // namespace pushback::to_each_its_own_tests
