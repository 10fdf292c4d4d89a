// A hull against a sphere or a capsule: the distance between the core, a segment, and the hull.
#include <cmath>
#include <optional>

#include "pushback/common/collision/collide_hull.h"
#include "pushback/common/collision/collide_segments.h"

namespace pushback {

namespace {

/// A stretch of a core, p(t) = centre + t half.
struct Stretch {
  Real begin = -1, end = 1;
  /// Keeps only t with height + t climb <= 0.
  void keep_below(Real height, Real climb) {
    if (climb > 0) end = std::min(end, -height / climb);
    else if (climb < 0) begin = std::max(begin, -height / climb);
    else if (height > 0) end = begin - 1;
  }
};

/// The stretch of the core inside the hull.
Stretch inside(const PlacedPolyhedron& hull, const Round& core) {
  Stretch stretch;
  for (int f = 0; f < int(hull.solid.faces.size()); ++f) {
    stretch.keep_below(hull.normal(f).dot(core.centre - hull.on(f)), hull.normal(f).dot(core.half));
  }
  return stretch;
}

/// The stretch of the core above or below a face.
Stretch beside_face(const PlacedPolyhedron& hull, const Round& core, int face) {
  Stretch stretch;
  const Polyhedron::Face& sides = hull.solid.faces[std::size_t(face)];
  for (std::size_t k = 0; k < sides.corners.size(); ++k) {
    const Polyhedron::Edge& edge = hull.solid.edges[std::size_t(sides.edges[k])];
    const Vec3 along = edge.from == sides.corners[k] ? hull.along(sides.edges[k]) : Vec3(-hull.along(sides.edges[k]));
    const Vec3 outward = along.cross(hull.normal(face)).normalized();
    stretch.keep_below(outward.dot(core.centre - hull.corner(edge.from)), outward.dot(core.half));
  }
  return stretch;
}

/// The stretch of the core between the planes perpendicular to an edge at its ends.
Stretch beside_edge(const PlacedPolyhedron& hull, const Round& core, int edge) {
  Stretch stretch;
  const Vec3 along = hull.along(edge).normalized();
  const Polyhedron::Edge& ends = hull.solid.edges[std::size_t(edge)];
  stretch.keep_below(along.dot(core.centre - hull.corner(ends.to)), along.dot(core.half));
  stretch.keep_below(-along.dot(core.centre - hull.corner(ends.from)), -along.dot(core.half));
  return stretch;
}

Nearest nearest_to_edge(const PlacedPolyhedron& hull, const Round& core, int edge) {
  const Vec3 half = hull.along(edge) / 2;
  const Vec3 middle = hull.corner(hull.solid.edges[std::size_t(edge)].from) + half;
  return nearest({half, core.half, core.centre - middle});
}

/// For a core outside the hull: its nearest point, as `t`, and the vector to it from the nearest point of the hull.
struct Gap {
  Real t = 0;
  Vec3 apart = Vec3::Zero();
  Real squared = std::numeric_limits<Real>::max();
  void keep_nearer(Real at, const Vec3& from_hull) {
    if (from_hull.squaredNorm() < squared) *this = {at, from_hull, from_hull.squaredNorm()};
  }
};
Gap gap_between(const PlacedPolyhedron& hull, const Round& core) {
  Gap gap;
  for (int e = 0; e < int(hull.solid.edges.size()); ++e) {
    const Nearest closest = nearest_to_edge(hull, core, e);
    gap.keep_nearer(closest.t, closest.apart);
  }
  for (int f = 0; f < int(hull.solid.faces.size()); ++f) {
    const Vec3& n = hull.normal(f);
    for (const Real end : {Real(-1), Real(1)}) {
      const Vec3 point = core.centre + end * core.half;
      const Real height = n.dot(point - hull.on(f));
      const Stretch stretch = beside_face(hull, {point, Vec3::Zero(), 0}, f);
      if (height > 0 && stretch.begin <= stretch.end) gap.keep_nearer(core.half.isZero(0) ? 0 : end, height * n);
    }
  }
  return gap;
}

/// The shortest way out of the hull for a core that crosses it: along the normal of a face, or perpendicular to the core and an
/// edge. Later ways must be clearly better than earlier ones, so that rounding does not choose.
struct WayOut {
  Vec3 normal = Vec3::UnitY();
  int face = -1, edge = -1;
  Real depth = std::numeric_limits<Real>::max();  // m, of the core without its radius
};
WayOut way_out(const PlacedPolyhedron& hull, const Round& core, Real clearly) {
  WayOut best;
  for (int f = 0; f < int(hull.solid.faces.size()); ++f) {
    const Vec3& n = hull.normal(f);
    const Real depth = std::abs(n.dot(core.half)) - n.dot(core.centre - hull.on(f));
    if (depth < best.depth - clearly) best = {n, f, -1, depth};
  }
  for (int e = 0; e < int(hull.solid.edges.size()) && !core.half.isZero(0); ++e) {
    const Polyhedron::Edge& edge = hull.solid.edges[std::size_t(e)];
    const Vec3 along = hull.along(e), across = along.cross(core.half);
    if (across.norm() < parallel * along.norm() * core.half.norm()) continue;
    const Vec3 outward = hull.normal(edge.left) + hull.normal(edge.right);
    const Vec3 n = (across.dot(outward) > 0 ? across : Vec3(-across)).normalized();
    const Real highest = n.dot(hull.corner(edge.from));
    if (hull.highest(n) > highest + hull.solid.rounding) continue;  // the hull reaches beyond this edge
    const Real depth = highest - n.dot(core.centre);
    if (depth < best.depth - clearly) best = {n, -1, e, depth};
  }
  return best;
}

/// The point of the core, as t, that leaves the hull last on its way out.
Real last_to_leave(const PlacedPolyhedron& hull, const Round& core, const WayOut& way) {
  if (way.edge >= 0) return nearest_to_edge(hull, core, way.edge).t;
  const Real climb = core.half.dot(way.normal);
  if (std::abs(climb) > parallel * core.half.norm()) return climb > 0 ? -1 : 1;
  const Stretch stretch = beside_face(hull, core, way.face);
  return std::clamp((stretch.begin + stretch.end) / 2, Real(-1), Real(1));
}

/// The face or the edge on which a core lies: nearly parallel to the core, and nearly perpendicular to `normal`.
struct Support {
  Vec3 normal;  // perpendicular to it
  Vec3 on;      // a point of it
  Stretch stretch;
};
std::optional<Support> support_of(const PlacedPolyhedron& hull, const Round& core, const Vec3& normal, Real clearly) {
  const Real length = core.half.norm();
  if (length == 0) return std::nullopt;
  constexpr Real near_copy = 1 - parallel * parallel / 2;
  for (int f = 0; f < int(hull.solid.faces.size()); ++f) {
    const Vec3& n = hull.normal(f);
    if (n.dot(normal) < near_copy || std::abs(n.dot(core.half)) > parallel * length) continue;
    return Support{n, hull.on(f), beside_face(hull, core, f)};
  }
  for (int e = 0; e < int(hull.solid.edges.size()); ++e) {
    const Vec3 along = hull.along(e).normalized();
    const Vec3& on = hull.corner(hull.solid.edges[std::size_t(e)].from);
    if (std::abs(along.dot(normal)) > parallel || along.cross(core.half).norm() > parallel * length) continue;
    const Vec3 square = (normal - along.dot(normal) * along).normalized();
    if (hull.highest(square) < square.dot(on) + clearly) return Support{square, on, beside_edge(hull, core, e)};
  }
  return std::nullopt;
}

}  // namespace

void touch(const Placed<Hull>& a, const Round& b, Manifold& found) {
  const PlacedPolyhedron hull(*a.shape.solid, a.centre, a.axes);
  const Real clearly = Real(1e-3) * hull.solid.half_width;
  const Real rounding = hull.solid.rounding + rounding_of(b.radius);
  Real t, depth;
  const Stretch within = inside(hull, b);
  const Gap gap = within.begin <= within.end ? Gap{0, Vec3::Zero(), 0} : gap_between(hull, b);
  const Real distance = std::sqrt(gap.squared);
  if (distance > b.radius + rounding + found.margin) return;
  if (distance > 100 * rounding) {
    t = gap.t;
    depth = b.radius - distance;
    found.normal = gap.apart / distance;
  } else {  // the direction between two points so near is mostly rounding
    const WayOut way = way_out(hull, b, clearly);
    t = last_to_leave(hull, b, way);
    depth = way.depth + b.radius;
    found.normal = way.normal;
  }
  found.overlap = depth;
  const auto add = [&](Real at, Real its_depth, std::uint32_t feature) {
    found.add(b.centre + at * b.half + (its_depth / 2 - b.radius) * found.normal, its_depth, feature);
  };

  std::uint32_t feature = b.half.isZero(0) ? somewhere : t <= -1 ? lower_end : t >= 1 ? upper_end : somewhere;
  if (const auto support = support_of(hull, b, found.normal, clearly)) {
    const auto [begin, end] = support->stretch;
    const Real length = end - begin;
    if (length * b.half.norm() > Real(0.01) * b.radius) {
      const auto depth_at = [&](Real at) {
        return b.radius - support->normal.dot(b.centre + at * b.half - support->on);
      };
      const Real depth_begin = depth_at(support->stretch.begin), depth_end = depth_at(support->stretch.end);
      if (depth_begin >= -rounding - found.margin && depth_end >= -rounding - found.margin) {
        found.normal = support->normal;
        add(begin, depth_begin, lower_end);
        add(end, depth_end, upper_end);
        return;
      }
      // One end has lifted off. The other is still the same contact.
      if (t < begin + length / 4) feature = lower_end;
      if (t > end - length / 4) feature = upper_end;
    }
  }
  add(t, depth, feature);
}

}  // namespace pushback
