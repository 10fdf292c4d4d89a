// Finds the faces of a hull. Every plane through three points that has no point beyond it contains one. The O(n^4) tests are
// few for the points of a stone, and a face with many corners is found as one face.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "pushback/common/basics/input.h"
#include "pushback/common/bodies/polyhedron.h"

namespace pushback {

namespace {

using Faces = std::vector<std::vector<int>>;
using Point = Eigen::Vector3d;  // double whatever Real is, because faces are found only once for a body

/// The corners of the polygon that a plane has in common with the hull, anticlockwise about the normal. All other points lie on
/// the left of a side, or on the side itself.
std::vector<int> loop_around(const std::vector<Point>& points, const std::vector<int>& in_plane, const Point& normal,
                             double near) {
  const auto next_after = [&](int from) {
    for (const int to : in_plane) {
      if (to == from) continue;
      const Point side = points[std::size_t(to)] - points[std::size_t(from)];
      const double length = side.norm();
      const Point along = side / length, left = normal.cross(along);
      const bool outermost = std::all_of(in_plane.begin(), in_plane.end(), [&](int other) {
        const Point p = points[std::size_t(other)] - points[std::size_t(from)];
        if (left.dot(p) > near) return true;
        return left.dot(p) >= -near && along.dot(p) >= -near && along.dot(p) <= length + near;
      });
      if (outermost) return to;
    }
    return -1;
  };
  // Start at a point that is certainly a corner, because it lies farthest from another point.
  const auto farther = [&](int p, int q) {
    const Point& from = points[std::size_t(in_plane.front())];
    return (points[std::size_t(p)] - from).squaredNorm() < (points[std::size_t(q)] - from).squaredNorm();
  };
  std::vector<int> loop = {*std::max_element(in_plane.begin(), in_plane.end(), farther)};
  for (int next = next_after(loop.back()); next >= 0 && loop.size() < in_plane.size(); next = next_after(next)) {
    if (next == loop.front()) break;
    loop.push_back(next);
  }
  return loop;
}

/// `near`: points at most this far (m) from a plane or a line lie in it; points at most twice as far from each other coincide.
Faces planes_around(const std::vector<Point>& points, double near) {
  std::vector<int> distinct;
  for (int i = 0; i < int(points.size()); ++i) {
    const bool is_new = std::none_of(distinct.begin(), distinct.end(), [&](int j) {
      return (points[std::size_t(i)] - points[std::size_t(j)]).norm() <= 2 * near;
    });
    if (is_new) distinct.push_back(i);
  }

  std::vector<std::uint32_t> known;  // planes: a bit for each point in them
  Faces faces;
  const auto try_plane = [&](int a, int b, int c) {
    const std::uint32_t three = 1u << a | 1u << b | 1u << c;
    if (std::any_of(known.begin(), known.end(), [&](std::uint32_t plane) { return (plane & three) == three; })) return;
    const Point& origin = points[std::size_t(a)];
    const Point ab = points[std::size_t(b)] - origin, ac = points[std::size_t(c)] - origin;
    const Point across = ab.cross(ac);
    const double longest = std::max({ab.norm(), ac.norm(), (ac - ab).norm()});
    if (!(across.norm() > near * longest)) return;
    Point normal = across.normalized();
    double above = 0, below = 0;
    std::uint32_t plane = 0;
    std::vector<int> in_plane;
    for (const int i : distinct) {
      const double height = normal.dot(points[std::size_t(i)] - origin);
      above = std::max(above, height);
      below = std::max(below, -height);
      if (std::abs(height) > near) continue;
      plane |= 1u << i;
      in_plane.push_back(i);
    }
    if (std::min(above, below) > near || std::max(above, below) <= near) return;
    if (above > near) normal = -normal;
    known.push_back(plane);
    faces.push_back(loop_around(points, in_plane, normal, near));
  };
  for (std::size_t i = 0; i < distinct.size(); ++i) {
    for (std::size_t j = i + 1; j < distinct.size(); ++j) {
      for (std::size_t k = j + 1; k < distinct.size(); ++k) try_plane(distinct[i], distinct[j], distinct[k]);
    }
  }
  return faces;
}

/// Whether each side of a face is also a side, in the opposite direction, of exactly one other face.
bool close(const Faces& faces) {
  std::array<std::array<int, most_corners>, most_corners> sides{};  // from each point to each other
  for (const auto& loop : faces) {
    for (std::size_t k = 0; k < loop.size(); ++k) {
      ++sides[std::size_t(loop[k])][std::size_t(loop[k + 1 == loop.size() ? 0 : k + 1])];
    }
  }
  for (std::size_t i = 0; i < sides.size(); ++i) {
    for (std::size_t j = 0; j < sides.size(); ++j) {
      if (sides[i][j] > 1 || sides[i][j] != sides[j][i]) return false;
    }
  }
  return true;
}

}  // namespace

// Rounding moves a plane through three points that span hardly more than `near` by at most eps * size^2 / near on the far side.
// That is less than `near`, so no feature is too thin to have a plane and too thick to be left out. But a point at just this
// distance lies in the plane of some neighbours and not in the plane of others, and then the faces do not close. A larger
// `near` finds them.
Faces faces_around(const std::vector<Vec3>& points) {
  std::vector<Point> exact;
  double size = 0;
  for (const Vec3& p : points) {
    exact.push_back(p.cast<double>());
    size = std::max(size, (exact.back() - exact.front()).norm());
  }
  const double least = std::max(4 * std::sqrt(std::numeric_limits<double>::epsilon()),
                                16 * static_cast<double>(std::numeric_limits<Real>::epsilon()));
  for (const int coarseness : {1, 3, 9, 27}) {
    const double near = coarseness * least * size;
    const Faces faces = planes_around(exact, near);
    if (faces.size() < 4) {
      throw InvalidInput("volume of a hull is 0: points that do not all lie in one plane are needed");
    }
    if (close(faces)) return faces;
  }
  throw InvalidInput("faces of a hull do not close: points farther apart, or farther from one plane, are needed");
}

}  // namespace pushback
