/// Where two bodies touch: a ball, a plane, and boxes by separating axes and clipping.
#pragma once

#include <limits>
#include <vector>

#include "body.h"

namespace empty_file {

/// One contact point.
struct Touch {
  Vec3 point;    // m, midway between the two surfaces
  Vec3 normal;   // unit, from A to B
  double depth;  // m, 0 or more
  int name = 0;  // which corners, edges and faces meet here: names.h
};
using Touches = std::vector<Touch>;

struct Ball {
  Vec3 centre;
  double radius;
};
/// Solid on the side that its normal, of length 1, points away from.
struct Plane {
  Vec3 normal;
  double offset;  // of its points p:   p . n = offset
};

/// A is the plane.
inline Touches touch(const Plane& plane, const Ball& ball) {
  const double depth = ball.radius - (ball.centre.dot(plane.normal) - plane.offset);
  if (depth < 0) return {};
  return {{ball.centre - (ball.radius - depth / 2) * plane.normal, plane.normal, depth}};
}

/// The corners of the box that are below the plane; each is called by its number.
inline Touches touch(const Plane& plane, const Body& box) {
  Touches found;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 signs(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
    const Vec3 at = box.position + box.orientation * box.half.cwiseProduct(signs);
    const double depth = plane.offset - at.dot(plane.normal);
    if (depth >= 0) found.push_back({at + depth / 2 * plane.normal, plane.normal, depth, corner});
  }
  return found;
}

inline Touches touch(const Ball& a, const Ball& b) {
  const Vec3 way = b.centre - a.centre;
  const double distance = way.norm(), depth = a.radius + b.radius - distance;
  if (depth < 0) return {};
  const Vec3 normal =
      distance > 0 ? Vec3(way / distance) : Vec3::UnitY();  // one centre on the other: any normal will do
  return {{a.centre + (a.radius - depth / 2) * normal, normal, depth}};
}

/// The direction along which two boxes overlap least.
struct Axis {
  Vec3 normal = Vec3::Zero();  // unit, from A to B
  double depth = std::numeric_limits<double>::max();
  int axis_a = -1, axis_b = -1;  // of a face of A, of a face of B, or of an edge of each

  bool of_edges() const { return axis_a >= 0 && axis_b >= 0; }
};

/// How far a box reaches from its centre along n, which has length 1.
inline double reach(const Body& box, const Vec3& n) {
  return (axes_of(box).transpose() * n).cwiseAbs().dot(box.half);
}

/// Two boxes are apart if and only if one of these axes separates them: the three of each, and the nine cross products.
/// Returns false as soon as one does.
inline bool least_overlap(const Body& a, const Body& b, Axis& least) {
  const Vec3 way = b.position - a.position;
  const double clearly =
      1e-3 * std::min(a.half.minCoeff(), b.half.minCoeff());  // or the axis would change at each step
  const auto overlaps = [&](Vec3 n, int axis_a, int axis_b) {
    const double length = n.norm();
    if (length < 1e-5) return true;  // edges as good as parallel: the faces beside them decide
    n *= (n.dot(way) < 0 ? -1 : 1) / length;
    const double depth = reach(a, n) + reach(b, n) - n.dot(way);
    if (depth < least.depth - clearly) least = {n, depth, axis_a, axis_b};
    return depth >= 0;
  };
  const Mat3 axes_a = axes_of(a), axes_b = axes_of(b);
  for (int i = 0; i < 3; ++i)
    if (!overlaps(axes_a.col(i), i, -1)) return false;
  for (int j = 0; j < 3; ++j)
    if (!overlaps(axes_b.col(j), -1, j)) return false;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (!overlaps(axes_a.col(i).cross(axes_b.col(j)), i, j)) return false;
  return true;
}

/// The middle of the edge along this axis that lies farthest along n.
inline Vec3 edge_along(const Body& box, int axis, const Vec3& n) {
  const Mat3 axes = axes_of(box);
  Vec3 middle = box.position;
  for (int i = 0; i < 3; ++i)
    if (i != axis) middle += (axes.col(i).dot(n) > 0 ? 1 : -1) * box.half[i] * axes.col(i);
  return middle;
}

/// Two edges touch at one point, where their lines come nearest.
inline Touch touch_of_edges(const Body& a, const Body& b, const Axis& axis) {
  const Vec3 p = edge_along(a, axis.axis_a, axis.normal), q = edge_along(b, axis.axis_b, -axis.normal);
  const Vec3 u = axes_of(a).col(axis.axis_a), v = axes_of(b).col(axis.axis_b);
  const double cosine = u.dot(v), sine2 = 1 - cosine * cosine;
  const double s = ((q - p).dot(u) - cosine * (q - p).dot(v)) / sine2;
  const double t = (cosine * (q - p).dot(u) - (q - p).dot(v)) / sine2;
  return {(p + s * u + q + t * v) / 2, axis.normal, axis.depth};
}

/// Which of a box's axes is nearest to n, up to its sign.
inline int face_along(const Body& box, const Vec3& n) {
  Eigen::Index nearest = 0;
  (axes_of(box).transpose() * n).cwiseAbs().maxCoeff(&nearest);
  return static_cast<int>(nearest);
}

}  // namespace empty_file
