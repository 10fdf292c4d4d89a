/// Helpers shared by the scenes of several exercises.
#pragma once

#include "pushback/common/exercise/exercise.h"
#include "pushback/common/world/world.h"

namespace pushback {

inline double between(Random& random, double low, double high) {
  return static_cast<double>(random.between(static_cast<Real>(low), static_cast<Real>(high)));
}

inline int whole(Random& random, int least, int most) {
  return least + static_cast<int>(random.below(static_cast<std::size_t>(most - least + 1)));
}

/// The ground, and a body right above the origin that touches it there. `gap`, m: its distance, negative for an overlap.
inline World on_the_ground(const Body& body, Real gap = 0) {
  World world;
  world.add(ground());
  world.add(body);
  world.contacts = {{.normal = Vec3::UnitY(), .depth = -gap, .id = {0, 1, 0}}};
  return world;
}

}  // namespace pushback
