// Hulls against hulls, boxes and half-spaces. As for boxes, the direction of least overlap gives the normal: the normal of a
// face, or the cross product of two edges.
//
//   D. Gregorius, The separating axis test between convex polyhedra, GDC 2013: which pairs of edges matter.
#include "pushback/common/collision/collide_hull.h"

#include <cmath>

#include "pushback/common/bodies/hull.h"
#include "pushback/common/collision/collide_segments.h"

namespace pushback {

PlacedPolyhedron::PlacedPolyhedron(const Polyhedron& which, const Vec3& centre, const Mat3& axes) : solid(which) {
  for (std::size_t i = 0; i < solid.corners.size(); ++i) corners[i] = centre + axes * solid.corners[i];
  for (std::size_t i = 0; i < solid.faces.size(); ++i) normals[i] = axes * solid.faces[i].normal;
}

Real PlacedPolyhedron::lowest(const Vec3& n) const {
  Real least = n.dot(corners[0]);
  for (std::size_t i = 1; i < solid.corners.size(); ++i) least = std::min(least, n.dot(corners[i]));
  return least;
}

Real PlacedPolyhedron::highest(const Vec3& n) const {
  return -lowest(-n);
}

int face_below(const PlacedPolyhedron& hull, const Vec3& n, Real clearly) {
  const Real low = hull.lowest(n) + clearly;
  int best = 0;
  Real most = -std::numeric_limits<Real>::max();
  for (std::size_t f = 0; f < hull.solid.faces.size(); ++f) {
    bool reaches_down = false, lies_flat = false;
    for (const int e : hull.solid.faces[f].edges) {
      const Polyhedron::Edge& edge = hull.solid.edges[std::size_t(e)];
      const Vec3 along = hull.along(e);
      if (std::min(n.dot(hull.corner(edge.from)), n.dot(hull.corner(edge.to))) > low) continue;
      reaches_down = true;
      if (std::abs(n.dot(along)) < parallel * along.norm()) lies_flat = true;
    }
    const Real squarely = (lies_flat ? 2 : 0) - n.dot(hull.normals[f]);
    if (reaches_down && squarely > most + Real(1e-3)) {
      best = int(f);
      most = squarely;
    }
  }
  return best;
}

namespace {

struct EdgeCrossing {
  int edge_a = -1, edge_b = -1;
  Vec3 normal = Vec3::Zero();  // unit, from A to B
  Real depth = std::numeric_limits<Real>::max();
};

/// The overlap of the hulls along the normal of each face, m.
using FaceDepths = std::array<Real, PlacedPolyhedron::most_faces>;

bool pass_each_other(const PlacedPolyhedron& hull, const FaceDepths& depths, const Vec3& normal, Real clearly) {
  for (std::size_t f = 0; f < hull.solid.faces.size(); ++f) {
    if (passes_at_face(hull.normals[f], depths[f], normal, clearly)) return true;
  }
  return false;
}

/// False if a face of `hull` has all of `other` beyond it.
bool try_faces(const HullPair& pair, bool of_b, FaceDepths& depths, HullFace& best) {
  const PlacedPolyhedron &hull = of_b ? pair.b : pair.a, &other = of_b ? pair.a : pair.b;
  for (int f = 0; f < int(hull.solid.faces.size()); ++f) {
    const Vec3& n = hull.normal(f);
    const Real depth = n.dot(hull.on(f)) - other.lowest(n);
    if (depth < -pair.rounding - pair.margin) return false;
    depths[std::size_t(f)] = depth;
    if (depth < best.depth - pair.clearly) best = {of_b, f, depth};
  }
  return true;
}

/// False if the cross product of two edges separates the hulls. On the sphere of directions, an edge of A is the arc between the
/// normals of its two faces, and an edge of B the arc between the opposites of its normals. Only if the arcs cross does nothing else
/// reach farther than the two edges along their cross product, so other pairs are skipped.
bool try_edges(const HullPair& pair, EdgeCrossing& best) {
  // The cross product of nearly parallel edges is too inexact, and the faces next to them decide as well.
  constexpr Real as_good_as_parallel = std::numeric_limits<Real>::digits > 24 ? Real(1e-10) : Real(1e-4);
  const auto& edges_a = pair.a.solid.edges;
  const auto& edges_b = pair.b.solid.edges;
  for (int i = 0; i < int(edges_a.size()); ++i) {
    const Polyhedron::Edge& edge_a = edges_a[std::size_t(i)];
    const Vec3 along_a = pair.a.along(i).normalized();
    const Vec3 &left_a = pair.a.normal(edge_a.left), &right_a = pair.a.normal(edge_a.right);
    for (int j = 0; j < int(edges_b.size()); ++j) {
      const Polyhedron::Edge& edge_b = edges_b[std::size_t(j)];
      const Real left_b = along_a.dot(pair.b.normal(edge_b.left)), right_b = along_a.dot(pair.b.normal(edge_b.right));
      if (left_b * right_b >= 0) continue;
      const Vec3 along_b = pair.b.along(j).normalized();
      const Real to_left = along_b.dot(left_a), to_right = along_b.dot(right_a);
      if (to_left * to_right >= 0 || left_b * to_right >= 0) continue;
      const Vec3 across = along_a.cross(along_b);
      const Real squared = across.squaredNorm();
      if (squared < as_good_as_parallel) continue;
      const Real length = std::sqrt(squared);
      const Vec3 normal = across / (across.dot(left_a + right_a) > 0 ? length : -length);
      const Real depth = normal.dot(pair.a.corner(edge_a.from) - pair.b.corner(edge_b.from));
      if (depth < -pair.rounding / length - pair.margin)
        return false;  // the shorter the product, the less exact its direction
      if (depth < best.depth - pair.clearly) best = {i, j, normal, depth};
    }
  }
  return true;
}

void touch_at_edges(const HullPair& pair, const EdgeCrossing& edges, Manifold& found) {
  const Vec3 half_a = pair.a.along(edges.edge_a) / 2, half_b = pair.b.along(edges.edge_b) / 2;
  const Vec3 middle_a = pair.a.corner(pair.a.solid.edges[std::size_t(edges.edge_a)].from) + half_a;
  const Vec3 middle_b = pair.b.corner(pair.b.solid.edges[std::size_t(edges.edge_b)].from) + half_b;
  const Nearest closest = nearest({half_a, half_b, middle_b - middle_a});
  found.normal = edges.normal;
  found.add((middle_a + closest.s * half_a + middle_b + closest.t * half_b) / 2, edges.depth,
            crossing(edges.edge_a, edges.edge_b));
}

void touch(const PlacedPolyhedron& a, const PlacedPolyhedron& b, Manifold& found) {
  const HullPair pair{a, b, Real(1e-3) * std::min(a.solid.half_width, b.solid.half_width),
                      std::max(a.solid.rounding, b.solid.rounding), found.margin};
  HullFace face;
  EdgeCrossing edges;
  FaceDepths depths_a, depths_b;
  if (!try_faces(pair, false, depths_a, face) || !try_faces(pair, true, depths_b, face) || !try_edges(pair, edges))
    return;

  // As for boxes, edges win only if their overlap is clearly less and their normal is no near copy of the face's.
  constexpr Real near_copy = 1 - parallel * parallel / 2;
  const Vec3 face_normal = face.of_b ? Vec3(-b.normal(face.face)) : a.normal(face.face);
  const bool edges_win = edges.depth < face.depth - pair.clearly && edges.normal.dot(face_normal) < near_copy;
  const auto pass = [&](const Vec3& normal) {
    return pass_each_other(a, depths_a, normal, pair.clearly) || pass_each_other(b, depths_b, normal, pair.clearly);
  };
  found.normal = edges_win ? edges.normal : face_normal;
  found.overlap = edges_win ? edges.depth : face.depth;
  found.passes = pass(found.normal);
  if (found.passes) return;
  if (!edges_win && touch_at_faces(pair, face, found)) return;
  if (edges.edge_a >= 0 && !pass(edges.normal)) touch_at_edges(pair, edges, found);
}

}  // namespace

void touch(const Placed<Hull>& a, const Placed<Hull>& b, Manifold& found) {
  touch(PlacedPolyhedron(*a.shape.solid, a.centre, a.axes), PlacedPolyhedron(*b.shape.solid, b.centre, b.axes), found);
}

void touch(const Placed<Hull>& a, const Placed<Box>& b, Manifold& found) {
  const Polyhedron box = polyhedron_of(b.shape);
  touch(PlacedPolyhedron(*a.shape.solid, a.centre, a.axes), PlacedPolyhedron(box, b.centre, b.axes), found);
}

namespace {

/// Sorts the candidates round their middle, so that any four in this order are the corners of a quadrilateral.
void put_in_a_circle(Candidate* candidates, int count) {
  Real u = 0, v = 0;
  for (int i = 0; i < count; ++i) {
    u += candidates[i].u / Real(count);
    v += candidates[i].v / Real(count);
  }
  const auto around = [u, v](const Candidate& c) {  // grows with the angle, from -2 to 2
    const Real du = c.u - u, dv = c.v - v, size = std::abs(du) + std::abs(dv);
    return size == 0 ? 0 : dv < 0 ? du / size - 1 : 1 - du / size;
  };
  std::stable_sort(candidates, candidates + count,
                   [&](const Candidate& p, const Candidate& q) { return around(p) < around(q); });
}

}  // namespace

// The feature is the number of the corner. All corners in the half-space count, whichever faces they belong to, because a stone may
// stand on an edge of one face and a corner of another.
void touch(const Placed<HalfSpace>& a, const Placed<Hull>& b, Manifold& found) {
  found.normal = a.axes * a.shape.normal;
  const PlacedPolyhedron hull(*b.shape.solid, b.centre, b.axes);
  const auto [across, over] = tangents_of(found.normal);
  std::array<Candidate, most_corners> candidates;
  int count = 0;
  for (int corner = 0; corner < int(hull.solid.corners.size()); ++corner) {
    const Vec3 from = hull.corner(corner) - a.centre;
    const Real depth = -found.normal.dot(from);
    if (depth < -hull.solid.rounding - found.margin) continue;
    candidates[std::size_t(count++)] = {across.dot(from), over.dot(from), depth, std::uint32_t(corner)};
  }
  if (count > 4) {
    put_in_a_circle(candidates.data(), count);
    reduce_to_four(candidates.data(), count, Real(1e-3) * hull.solid.half_width);
    count = 4;
  }
  std::sort(candidates.begin(), candidates.begin() + count,
            [](const Candidate& p, const Candidate& q) { return p.feature < q.feature; });
  for (int i = 0; i < count; ++i) {
    const Candidate& one = candidates[std::size_t(i)];
    found.add(hull.corner(int(one.feature)) + one.depth / 2 * found.normal, one.depth, one.feature);
  }
}

}  // namespace pushback
