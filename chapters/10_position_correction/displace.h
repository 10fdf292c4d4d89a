/// Moves a body without a velocity.
#pragma once

#include "pushback/common/bodies/body.h"

namespace pushback {

/// x += shift (m),  q' = normalise(q + (0, turn) q / 2)  (rad),  both in world axes. The velocities do not change.
inline void displace(Body& body, const Vec3& shift, const Vec3& turn) {
  body.position += shift;
  if (turn == Vec3::Zero()) return;
  const Vec3 half = turn / 2;
  body.orientation = (Quat(1, half.x(), half.y(), half.z()) * body.orientation).normalized();
  body.refresh_inertia();
}

}  // namespace pushback
