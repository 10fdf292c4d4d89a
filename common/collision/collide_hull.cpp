// Hulls against hulls, boxes and half-spaces. As for boxes, the direction of least overlap gives the normal: the normal of a
// face, or the cross product of two edges.
#include "pushback/common/collision/collide_hull.h"

#include <cmath>

#include "pushback/common/bodies/hull.h"

namespace pushback {

PlacedPolyhedron::PlacedPolyhedron(const Polyhedron& which, const Vec3& where, const Mat3& axes)
    : solid(which), centre(where) {
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

Real PlacedPolyhedron::inner_radius() const {
  Real least = std::numeric_limits<Real>::max();
  for (const Polyhedron::Face& face : solid.faces) least = std::min(least, face.offset);
  return least;
}

int face_below(const PlacedPolyhedron& hull, const Vec3& n, Real clearly) {
  std::array<Real, most_corners> heights;
  const std::size_t corners = hull.solid.corners.size();
  for (std::size_t i = 0; i < corners; ++i) heights[i] = n.dot(hull.corners[i]);
  const Real low = *std::min_element(heights.begin(), heights.begin() + corners) + clearly;
  constexpr Real preferred = 2;  // as much as n . normal can differ
  int best = 0;
  Real most = -std::numeric_limits<Real>::max();
  for (std::size_t f = 0; f < hull.solid.faces.size(); ++f) {
    const Real facing = -n.dot(hull.normals[f]), enough = most + Real(1e-3);
    if (preferred + facing <= enough) continue;
    bool reaches_down = false, lies_flat = false;
    for (const int e : hull.solid.faces[f].edges) {
      const Polyhedron::Edge& edge = hull.solid.edges[std::size_t(e)];
      if (std::min(heights[std::size_t(edge.from)], heights[std::size_t(edge.to)]) > low) continue;
      reaches_down = true;
      const Vec3 along = hull.along(e);
      if (std::abs(n.dot(along)) < parallel * along.norm()) lies_flat = true;
    }
    const Real squarely = (lies_flat ? preferred : 0) + facing;
    if (reaches_down && squarely > enough) {
      best = int(f);
      most = squarely;
    }
  }
  return best;
}

namespace {

/// The overlap of the hulls along the normal of each face, m.
using FaceDepths = std::array<Real, PlacedPolyhedron::most_faces>;

bool pass_each_other(const PlacedPolyhedron& hull, const FaceDepths& depths, const Vec3& normal, Real clearly) {
  for (std::size_t f = 0; f < hull.solid.faces.size(); ++f) {
    if (passes_at_face(hull.normals[f], depths[f], normal, clearly)) return true;
  }
  return false;
}

/// False if a face of `hull` has all of `other` beyond it. The overlap is at least the depth of the ball that fits into `other` round its
/// centre. If that is so much that the face neither gives the normal nor lets the hulls pass, it stands for the overlap.
bool try_faces(const HullPair& pair, bool of_b, FaceDepths& depths, HullFace& best) {
  const PlacedPolyhedron &hull = of_b ? pair.b : pair.a, &other = of_b ? pair.a : pair.b;
  const Real ball = other.inner_radius();
  for (int f = 0; f < int(hull.solid.faces.size()); ++f) {
    const Vec3& n = hull.normal(f);
    Real& depth = depths[std::size_t(f)];
    depth = n.dot(hull.on(f) - other.centre) + ball;
    if (depth > std::max(pair.clearly, best.depth)) continue;
    depth = n.dot(hull.on(f)) - other.lowest(n);
    if (depth < -pair.rounding - pair.margin) return false;
    if (depth < best.depth - pair.clearly) best = {of_b, f, depth};
  }
  return true;
}

/// Whether a ball of this radius (m) lies in the hull.
bool contains(const PlacedPolyhedron& hull, const Vec3& centre, Real radius) {
  for (int f = 0; f < int(hull.solid.faces.size()); ++f) {
    if (hull.normal(f).dot(centre - hull.on(f)) > -radius) return false;
  }
  return true;
}

/// Whether the points at which the faces touch prove that no pair of edges can overlap clearly less than the faces, or separate the hulls.
/// If a ball of diameter d lies in both hulls, they overlap by at least d along every direction. If a point of A and a point of B are d
/// apart, no direction separates the hulls by more than d. Ball and points are placed at the middle of the contact.
bool faces_decide(const HullPair& pair, const Manifold& at_faces) {
  if (at_faces.count == 0) return false;
  Vec3 middle = Vec3::Zero();
  for (int i = 0; i < at_faces.count; ++i) middle += at_faces.touches[i].point / Real(at_faces.count);
  // Edges that win overlap less by more than `clearly`. Half of that is left for rounding.
  const Real least = std::max(at_faces.overlap - pair.clearly / 2, -pair.margin);
  const Real radius = std::max(least, Real(0)) / 2;
  const Vec3 half_gap = std::max(-least, Real(0)) / 2 * at_faces.normal;
  return contains(pair.a, middle - half_gap, radius) && contains(pair.b, middle + half_gap, radius);
}

void touch(const PlacedPolyhedron& a, const PlacedPolyhedron& b, Manifold& found) {
  const HullPair pair{a, b, Real(1e-3) * std::min(a.solid.half_width, b.solid.half_width),
                      std::max(a.solid.rounding, b.solid.rounding), found.margin};
  HullFace face;
  FaceDepths depths_a, depths_b;
  if (!try_faces(pair, false, depths_a, face) || !try_faces(pair, true, depths_b, face)) return;
  const auto pass = [&](const Vec3& normal) {
    return pass_each_other(a, depths_a, normal, pair.clearly) || pass_each_other(b, depths_b, normal, pair.clearly);
  };
  Manifold at_faces = found;
  at_faces.normal = face.of_b ? Vec3(-b.normal(face.face)) : a.normal(face.face);
  at_faces.overlap = face.depth;
  at_faces.passes = pass(at_faces.normal);
  if (!at_faces.passes) touch_at_faces(pair, face, at_faces);
  EdgeCrossing edges;
  if (!faces_decide(pair, at_faces) && !try_edges(pair, edges)) return;

  // As for boxes, edges win only if their overlap is clearly less and their normal is no near copy of the face's.
  constexpr Real near_copy = 1 - parallel * parallel / 2;
  const bool edges_win = edges.depth < face.depth - pair.clearly && edges.normal.dot(at_faces.normal) < near_copy;
  if (edges_win) {
    found.normal = edges.normal;
    found.overlap = edges.depth;
    found.passes = pass(edges.normal);
  } else {
    found = at_faces;
  }
  if (found.passes || found.count > 0) return;
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
