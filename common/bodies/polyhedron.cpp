#include "pushback/common/bodies/polyhedron.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "pushback/common/bodies/hull.h"
#include "pushback/common/collision/collide_shapes.h"

namespace pushback {

namespace {

/// Twice the area of a polygon, as a vector: the sum over its sides. M. Newell's formula.
Vec3 doubled_area(const std::vector<Vec3>& corners, const std::vector<int>& loop) {
  const Vec3& origin = corners[std::size_t(loop.front())];
  Vec3 sum = Vec3::Zero();
  for (std::size_t k = 2; k < loop.size(); ++k) {
    sum += (corners[std::size_t(loop[k - 1])] - origin).cross(corners[std::size_t(loop[k])] - origin);
  }
  return sum;
}

/// Computes all normals, offsets and half-widths. The corners are given, and for each face and edge the numbers of its corners.
void measure(Polyhedron& solid) {
  solid.half_width = std::numeric_limits<Real>::max();
  for (Polyhedron::Face& face : solid.faces) {
    face.normal = doubled_area(solid.corners, face.corners).normalized();
    face.offset = 0;
    for (const int i : face.corners) {
      face.offset += face.normal.dot(solid.corners[std::size_t(i)]) / Real(face.corners.size());
    }
    Real lowest = face.offset;
    for (const Vec3& corner : solid.corners) lowest = std::min(lowest, face.normal.dot(corner));
    solid.half_width = std::min(solid.half_width, (face.offset - lowest) / 2);
  }
  for (Polyhedron::Face& face : solid.faces) {
    face.half_width = std::numeric_limits<Real>::max();
    for (const int e : face.edges) {
      const Polyhedron::Edge& edge = solid.edges[std::size_t(e)];
      const Vec3& start = solid.corners[std::size_t(edge.from)];
      const Vec3 along = (solid.corners[std::size_t(edge.to)] - start).normalized();
      Real width = 0;
      for (const int i : face.corners)
        width = std::max(width, along.cross(solid.corners[std::size_t(i)] - start).norm());
      face.half_width = std::min(face.half_width, width / 2);
    }
  }
}

}  // namespace

Polyhedron polyhedron(const std::vector<Vec3>& points, const std::vector<std::vector<int>>& faces) {
  Polyhedron solid;
  std::vector<int> number(points.size(), -1);
  for (const auto& loop : faces) {
    for (const int point : loop) number[std::size_t(point)] = 0;
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (number[i] < 0) continue;
    number[i] = int(solid.corners.size());
    solid.corners.push_back(points[i]);
  }
  for (const auto& loop : faces) {
    Polyhedron::Face& face = solid.faces.emplace_back();
    for (const int point : loop) face.corners.push_back(number[std::size_t(point)]);
  }

  using Edge = Polyhedron::Edge;
  const auto each_side = [&](const auto& visit) {
    for (std::size_t f = 0; f < solid.faces.size(); ++f) {
      const std::vector<int>& loop = solid.faces[f].corners;
      for (std::size_t k = 0; k < loop.size(); ++k) visit(int(f), loop[k], loop[k + 1 == loop.size() ? 0 : k + 1]);
    }
  };
  const auto before = [](const Edge& p, const Edge& q) { return std::pair(p.from, p.to) < std::pair(q.from, q.to); };
  each_side([&](int face, int from, int to) {
    if (from < to) solid.edges.push_back({from, to, face, -1});
  });
  std::sort(solid.edges.begin(), solid.edges.end(), before);
  each_side([&](int face, int from, int to) {
    const Edge wanted{std::min(from, to), std::max(from, to), -1, -1};
    const auto edge = std::lower_bound(solid.edges.begin(), solid.edges.end(), wanted, before);
    (from < to ? edge->left : edge->right) = face;
    solid.faces[std::size_t(face)].edges.push_back(int(edge - solid.edges.begin()));
  });
  measure(solid);
  return solid;
}

Polyhedron polyhedron_of(const Box& box) {
  static const Polyhedron cube = [] {
    std::vector<Vec3> corners;
    for (int corner = 0; corner < 8; ++corner)
      corners.push_back(
          {(corner & 1) ? Real(1) : Real(-1), (corner & 2) ? Real(1) : Real(-1), (corner & 4) ? Real(1) : Real(-1)});
    return polyhedron(corners, {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}});
  }();
  Polyhedron solid = cube;
  for (Vec3& corner : solid.corners) corner = corner.cwiseProduct(box.half_extents).eval();
  measure(solid);
  solid.volume = 8 * box.half_extents.prod();
  solid.rounding = rounding_of(box.half_extents.maxCoeff());
  return solid;
}

}  // namespace pushback
