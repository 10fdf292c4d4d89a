/// The rotation from one direction to another.
#pragma once

#include <algorithm>
#include <cmath>

#include "pushback/common/basics/types.h"

namespace pushback {

/// The shortest rotation from the direction of a to the direction of b, or one half turn if they are opposite. All other
/// results equal the bits of Eigen's FromTwoVectors, which takes 8 s to compile because it finds the axis of a half turn by a
/// singular value decomposition.
inline Quat shortest_turn(const Vec3& a, const Vec3& b) {
  const Vec3 from = a.normalized(), to = b.normalized();
  const Real cosine = to.dot(from);
  Quat turn;
  if (cosine < Real(-1) + Eigen::NumTraits<Real>::dummy_precision()) {
    const Real w2 = (1 + std::max(cosine, Real(-1))) * Real(0.5);
    turn.w() = std::sqrt(w2);
    turn.vec() = tangents_of(from).tangent1 * std::sqrt(1 - w2);
    return turn;
  }
  const Real s = std::sqrt((1 + cosine) * 2);
  turn.vec() = from.cross(to) * (1 / s);
  turn.w() = s * Real(0.5);
  return turn;
}

}  // namespace pushback
