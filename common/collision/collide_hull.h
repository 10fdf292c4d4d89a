/// Shared by the functions for hulls: collide_hull.cpp, collide_hull_faces.cpp, collide_hull_edges.cpp and collide_hull_round.cpp.
#pragma once

#include <array>

#include "pushback/common/collision/collide_outline.h"
#include "pushback/common/collision/collide_shapes.h"

namespace pushback {

/// A polyhedron in its pose: in world axes, m, relative to the first body of the pair.
struct PlacedPolyhedron {
  static constexpr int most_faces = 2 * most_corners - 4, most_edges = 3 * most_corners - 6;  // by Euler's formula
  const Polyhedron& solid;
  Vec3 centre;
  std::array<Vec3, most_corners> corners;
  std::array<Vec3, most_faces> normals;

  PlacedPolyhedron(const Polyhedron& which, const Vec3& where, const Mat3& axes);
  const Vec3& corner(int i) const { return corners[std::size_t(i)]; }
  const Vec3& normal(int face) const { return normals[std::size_t(face)]; }
  const Vec3& on(int face) const { return corner(solid.faces[std::size_t(face)].corners[0]); }
  Vec3 along(int edge) const {  ///< not of unit length
    const Polyhedron::Edge& e = solid.edges[std::size_t(edge)];
    return corner(e.to) - corner(e.from);
  }
  Real lowest(const Vec3& n) const;   ///< the least n . corner
  Real highest(const Vec3& n) const;  ///< the largest
  Real inner_radius() const;          ///< m, of the largest ball round the centre
};

/// The incident face for a reference face's normal n. Among the faces that contain the lowest corner along n, it is the one whose
/// normal is nearest to -n. A face with an edge at that height takes precedence over all others, because a wedge rests on its
/// whole blade. Height differences up to `clearly` (m) and differences of n . normal up to 1e-3 do not count. Ties go to the first.
int face_below(const PlacedPolyhedron& hull, const Vec3& n, Real clearly);

/// Overlaps that differ by no more than `clearly` (m) count as equal, so that rounding does not choose. `rounding` and `margin` are
/// as in BoxPair.
struct HullPair {
  const PlacedPolyhedron &a, &b;
  Real clearly, rounding, margin;
};

/// The face along whose normal two polyhedra overlap least.
struct HullFace {
  bool of_b = false;
  int face = 0;
  Real depth = std::numeric_limits<Real>::max();
};

/// Clips the incident face to the reference face and adds the points below it to `found`, which has the normal already.
void touch_at_faces(const HullPair& pair, const HullFace& face, Manifold& found);

/// Two edges along whose cross product the polyhedra overlap least.
struct EdgeCrossing {
  int edge_a = -1, edge_b = -1;
  Vec3 normal = Vec3::Zero();  ///< unit, from A to B
  Real depth = std::numeric_limits<Real>::max();
};

/// False if the cross product of two edges separates the polyhedra. On the sphere of directions, an edge of A is the arc between the
/// normals of its two faces, and an edge of B is the arc between the opposites of its normals. The two edges are the extreme points
/// of their polyhedra along their cross product only if the arcs cross, so other pairs of edges are skipped.
bool try_edges(const HullPair& pair, EdgeCrossing& best);

/// Adds the point at which the edges touch to `found`.
void touch_at_edges(const HullPair& pair, const EdgeCrossing& edges, Manifold& found);

}  // namespace pushback
