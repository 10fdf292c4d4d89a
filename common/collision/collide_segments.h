/// The nearest points of two segments, for round shapes, and for a round shape at an edge of a hull.
#pragma once

#include <algorithm>

#include "pushback/common/basics/types.h"

namespace pushback {

inline Real into_core(Real s) {
  return std::clamp(s, Real(-1), Real(1));
}

/// A point of each core: a.centre + s a.half and b.centre + t b.half. `apart` leads from the first to the second.
struct Nearest {
  Real s, t;
  Vec3 apart;
};

/// Two segments, with the products that every query needs.
struct Segments {
  const Vec3 &half_a, &half_b;
  Vec3 between;  // from the centre of A to the centre of B
  Real aa = half_a.squaredNorm(), bb = half_b.squaredNorm(), ab = half_a.dot(half_b);
  Real a_between = half_a.dot(between), b_between = half_b.dot(between);

  Real nearest_to_b(Real t) const { return aa > 0 ? into_core((a_between + t * ab) / aa) : 0; }  // gives s
  Real nearest_to_a(Real s) const { return bb > 0 ? into_core((s * ab - b_between) / bb) : 0; }  // gives t
  Nearest at(Real s, Real t) const { return {s, t, between + t * half_b - s * half_a}; }
};

/// The nearest points, or one such pair if the segments are parallel.
Nearest nearest(const Segments& segments);

}  // namespace pushback
