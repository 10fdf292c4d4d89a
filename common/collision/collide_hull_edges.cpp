// Edge against edge.
//
//   D. Gregorius, The separating axis test between convex polyhedra, GDC 2013: which pairs of edges matter.
#include <cmath>

#include "pushback/common/collision/collide_hull.h"
#include "pushback/common/collision/collide_segments.h"

namespace pushback {

namespace {

/// Whether two directions point to opposite sides of a plane. `left`, `right`: their components along its normal.
bool opposite(Real left, Real right) {
  return left * right < 0;
}

}  // namespace

bool try_edges(const HullPair& pair, EdgeCrossing& best) {
  // The cross product of nearly parallel edges is too inexact, and the faces next to them decide as well.
  constexpr Real as_good_as_parallel = std::numeric_limits<Real>::digits > 24 ? Real(1e-10) : Real(1e-4);
  const auto& edges_a = pair.a.solid.edges;
  const auto& edges_b = pair.b.solid.edges;
  std::array<Vec3, PlacedPolyhedron::most_edges> along_b;
  for (std::size_t j = 0; j < edges_b.size(); ++j) along_b[j] = pair.b.along(int(j)).normalized();
  std::array<Real, PlacedPolyhedron::most_faces> normals_b;  // their components along an edge of A
  for (std::size_t i = 0; i < edges_a.size(); ++i) {
    const Vec3 along_a = pair.a.along(int(i)).normalized();
    for (std::size_t f = 0; f < pair.b.solid.faces.size(); ++f) normals_b[f] = along_a.dot(pair.b.normals[f]);
    const Vec3 &left_a = pair.a.normal(edges_a[i].left), &right_a = pair.a.normal(edges_a[i].right);
    for (std::size_t j = 0; j < edges_b.size(); ++j) {
      const Real left_b = normals_b[std::size_t(edges_b[j].left)], right_b = normals_b[std::size_t(edges_b[j].right)];
      if (!opposite(left_b, right_b)) continue;
      const Real to_left = along_b[j].dot(left_a), to_right = along_b[j].dot(right_a);
      if (!opposite(to_left, to_right) || !opposite(left_b, to_right)) continue;
      const Vec3 across = along_a.cross(along_b[j]);
      const Real squared = across.squaredNorm();
      if (squared < as_good_as_parallel) continue;
      const Real length = std::sqrt(squared);
      const Vec3 normal = across / (across.dot(left_a + right_a) > 0 ? length : -length);
      const Real depth = normal.dot(pair.a.corner(edges_a[i].from) - pair.b.corner(edges_b[j].from));
      if (depth < -pair.rounding / length - pair.margin)
        return false;  // the shorter the product, the less exact its direction
      if (depth < best.depth - pair.clearly) best = {int(i), int(j), normal, depth};
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

}  // namespace pushback
