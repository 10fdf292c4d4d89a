/// Tiles that lie flush, for what slides or rolls over them.
#pragma once

#include "pushback/common/world/world.h"

namespace pushback {

/// Immovable cubes whose tops are the plane y = 0: those within `aside` of a way that leads `ahead` from `from` along `along`, and 1 m
/// behind it. All in m.
inline void add_tiles(World& world, Real half, const Vec3& from, const Vec3& along, Real ahead, Real aside, Real mu) {
  for (int x = -24; x <= 24; ++x) {
    for (int z = -24; z <= 24; ++z) {
      const Vec3 at(2 * half * static_cast<Real>(x), -half, 2 * half * static_cast<Real>(z)), there = at - from;
      const Real way = there.dot(along), beside = (Vec3(there.x(), 0, there.z()) - way * along).norm();
      if (way > -1 && way < ahead && beside < aside) world.add(box(Vec3::Constant(half), 1).fixed().at(at).rough(mu));
    }
  }
}

}  // namespace pushback
