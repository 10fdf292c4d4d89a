/// Random scenes, including extreme ones, each generated from a number.
#pragma once

#include <cstdint>

#include "pushback/common/world/world.h"

namespace pushback {

struct RandomScene {
  World world;
  Real dt = Real(1) / 60;  ///< s
  bool isolated = false;   ///< no gravity and no immovable bodies, so momentum and angular momentum are conserved
};

/// A scene of 1 to 20 bodies. Half of the scenes are ordinary, a heap above the ground or boxes that stand on each other. The others
/// have masses of 1e-3 to 1e6 kg, sizes of 1 mm to 100 m in each direction independently (needles and plates, also as hulls), up to
/// 500 m/s and 1000 rad/s, any overlap up to coincident centres, mu up to 10, e up to 1, fixed bodies, several half-spaces, distances
/// of up to 1e7 m from the origin, and steps other than 1/60 s. The same seed gives the same bits with every compiler and library.
///
/// At least one point is outside all half-spaces, but there may be no free space around it.
RandomScene random_scene(std::uint64_t seed);

}  // namespace pushback
