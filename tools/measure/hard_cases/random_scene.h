/// Scenes that nobody would think of, each from a number.
#pragma once

#include <cstdint>

#include "pushback/common/world/world.h"

namespace pushback {

struct RandomScene {
  World world;
  Real dt = Real(1) / 60;  ///< s
  bool isolated = false;   ///< no gravity and nothing fixed: momentum and angular momentum are kept
};

/// 1 to 20 bodies. Half of the scenes are ordinary: a heap above the ground, or boxes that stand on each other. In the others
/// nothing is: 1e-3 to 1e6 kg, 1 mm to 100 m in each direction by itself (needles, plates; hulls too), up to 500 m/s and
/// 1000 rad/s, any overlap up to one place for all centres, mu up to 10, e up to 1, fixed bodies, several half-spaces, up to
/// 1e7 m from the origin, other steps than 1/60 s. The same seed gives the same bits with every compiler and library.
///
/// There is a point that all half-spaces leave free, though not always room around it.
RandomScene random_scene(std::uint64_t seed);

}  // namespace pushback
