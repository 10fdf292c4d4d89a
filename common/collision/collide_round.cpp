// Spheres and capsules against each other: the distance between two segments.
#include <cmath>

#include "pushback/common/collision/collide_segments.h"
#include "pushback/common/collision/collide_shapes.h"

namespace pushback {

// The least distance is either between two inner points, where the connection is perpendicular to both, or at one of
// the four ends.
Nearest nearest(const Segments& segments) {
  const Real s = segments.nearest_to_b(0);
  Nearest best = segments.at(s, segments.nearest_to_a(s));
  Real least = best.apart.squaredNorm();
  const auto try_at = [&](Real at_s, Real at_t) {
    const Nearest candidate = segments.at(at_s, at_t);
    if (const Real distance = candidate.apart.squaredNorm(); distance < least) {
      least = distance;
      best = candidate;
    }
  };
  if (segments.aa > 0 && segments.bb > 0) {
    const Real slant = segments.half_a.cross(segments.half_b).squaredNorm();  // 0 where they are parallel
    if (slant > rounding_of(segments.aa * segments.bb)) {
      const Real inner = into_core((segments.a_between * segments.bb - segments.ab * segments.b_between) / slant);
      try_at(inner, segments.nearest_to_a(inner));
    }
  }
  for (const Real end : {Real(-1), Real(1)}) {
    if (segments.bb > 0) try_at(segments.nearest_to_b(end), end);
    if (segments.aa > 0) try_at(end, segments.nearest_to_a(end));
  }
  return best;
}

namespace {

/// A direction that separates two cores that cross: perpendicular to both, because that is the shortest way.
Vec3 way_out(const Round& a, const Round& b) {
  const Vec3 across = a.half.cross(b.half);
  const Real size = a.half.norm() * b.half.norm();
  if (across.norm() > Real(1e-3) * size) return across.normalized();
  const Vec3& longer = a.half.squaredNorm() >= b.half.squaredNorm() ? a.half : b.half;
  if (longer.isZero(0)) return Vec3::UnitY();  // two centres in one place: any direction will do
  return tangents_of(longer.normalized()).tangent1;
}

}  // namespace

void touch(const Round& a, const Round& b, Manifold& found) {
  const Segments segments{a.half, b.half, b.centre - a.centre};
  const Nearest closest = nearest(segments);
  const Real radii = a.radius + b.radius;
  const Real distance = closest.apart.norm();
  const Real rounding = rounding_of(radii);
  if (distance > radii + rounding + found.margin) return;

  if (distance > rounding) {
    found.normal = closest.apart / distance;
  } else {
    found.normal = way_out(a, b);
    if (found.normal.dot(segments.between) < -rounding) found.normal = -found.normal;
  }
  const auto point = [&](Real s, Real t) -> Vec3 {
    const Vec3 cores = a.centre + s * a.half + b.centre + t * b.half;
    return (cores + (a.radius - b.radius) * found.normal) / 2;
  };

  std::uint32_t feature = somewhere;
  const Real size = std::sqrt(segments.aa * segments.bb);
  if (size > 0 && a.half.cross(b.half).norm() < parallel * size) {
    // The cores lie side by side, so both ends of the stretch in which A lies next to B can touch.
    Real ends[2] = {segments.nearest_to_b(-1), segments.nearest_to_b(1)};
    if (ends[0] > ends[1]) std::swap(ends[0], ends[1]);
    const Real stretch = ends[1] - ends[0];
    if (stretch * std::sqrt(segments.aa) > Real(0.01) * radii) {
      Real opposite[2], depth[2];
      for (int i = 0; i < 2; ++i) {
        opposite[i] = segments.nearest_to_a(ends[i]);
        depth[i] = radii - found.normal.dot(segments.at(ends[i], opposite[i]).apart);
      }
      if (depth[0] >= -rounding - found.margin && depth[1] >= -rounding - found.margin) {
        found.add(point(ends[0], opposite[0]), depth[0], lower_end);
        found.add(point(ends[1], opposite[1]), depth[1], upper_end);
        return;
      }
      // One end has lifted off. The other is still the same contact.
      if (closest.s < ends[0] + stretch / 4) feature = lower_end;
      if (closest.s > ends[1] - stretch / 4) feature = upper_end;
    }
  }
  found.add(point(closest.s, closest.t), radii - distance, feature);
}

}  // namespace pushback
