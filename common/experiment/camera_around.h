/// A camera for scenes that do not define one.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "pushback/common/render/picture.h"
#include "pushback/common/world/world.h"

namespace pushback {

/// A camera above and in front of the movable bodies, far enough away to show all of them. `worlds`: a motion, of which the first, the
/// middle and the last world count.
inline Camera camera_around(const std::vector<World>& worlds) {
  Vec3 low = Vec3::Constant(std::numeric_limits<Real>::infinity()), high = -low;
  for (const World* world : {&worlds.front(), &worlds[worlds.size() / 2], &worlds.back()})
    for (const Body& body : world->bodies) {
      if (!body.movable()) continue;
      low = low.cwiseMin(body.position);
      high = high.cwiseMax(body.position);
    }
  const Vec3 middle = (low + high) / 2;
  const Real size = std::max(Real(1), (high - low).norm());
  return {middle + size * Vec3(Real(0.15), Real(0.25), Real(1.05)), middle};
}

}  // namespace pushback
