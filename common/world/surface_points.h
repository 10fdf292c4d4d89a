/// The two surface points of a contact, fixed to their bodies.
#pragma once

#include "pushback/common/world/world.h"

namespace pushback {

/// P_A and P_B of a contact:   (P_A - P_B) . n = depth,   (P_A + P_B) / 2 = point
struct SurfacePoints {
  Vec3 on_a, on_b;  ///< m, body axes from the centres of mass

  SurfacePoints(const Body& a, const Body& b, const Contact& at) {
    const Vec3 half = at.depth / 2 * at.normal;  // from midway to A's point, which is the farther one along n
    on_a = point_on(a, at.point + half);
    on_b = point_on(b, at.point - half);
  }
};

}  // namespace pushback
