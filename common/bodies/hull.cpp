#include "pushback/common/bodies/hull.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "pushback/common/basics/input.h"
#include "pushback/common/bodies/polyhedron.h"
#include "pushback/common/collision/collide_shapes.h"

namespace pushback {

namespace {

/// Volume, centre of mass and inertia of a uniform solid.
struct Moments {
  Real volume = 0;
  Vec3 centre = Vec3::Zero();
  Mat3 inertia_per_kilogram = Mat3::Zero();  // about the centre of mass
};

// The solid is the sum of the tetrahedra between the origin and the triangles a, b, c of its faces. A tetrahedron has the
// volume V = a . (b x c) / 6. Its integral of x is V (a + b + c) / 4, and its integral of x x^T is
// V (a a^T + b b^T + c c^T + (a + b + c)(a + b + c)^T) / 20.
//   F. Tonon, Explicit exact formulas for the 3-D tetrahedron inertia tensor, J. Math. Stat. 1(1), 2005.
Moments moments_of(const Polyhedron& solid) {
  Moments sum;
  Mat3 second = Mat3::Zero();
  const auto corner = [&](int i) -> const Vec3& { return solid.corners[std::size_t(i)]; };
  for (const Polyhedron::Face& face : solid.faces) {
    for (std::size_t k = 2; k < face.corners.size(); ++k) {
      const Vec3 &a = corner(face.corners[0]), &b = corner(face.corners[k - 1]), &c = corner(face.corners[k]);
      const Vec3 together = a + b + c;
      const Real volume = a.dot(b.cross(c)) / 6;
      sum.volume += volume;
      sum.centre += volume / 4 * together;
      second += volume / 20 *
                (a * a.transpose() + b * b.transpose() + c * c.transpose() + together * together.transpose()).eval();
    }
  }
  require_positive("volume of a hull", sum.volume);
  sum.centre /= sum.volume;
  const Mat3 spread = second / sum.volume - sum.centre * sum.centre.transpose();
  sum.inertia_per_kilogram = spread.trace() * Mat3::Identity() - spread;
  return sum;
}

/// Names three directions x, y and z: of the 24 right-handed ways the one that turns the axes least.
Mat3 named(const Mat3& directions) {
  std::array<int, 3> order = {0, 1, 2};
  Mat3 best = Mat3::Identity();
  Real most_alike = -std::numeric_limits<Real>::max();
  do {
    Mat3 axes;
    for (int i = 0; i < 3; ++i) {
      const auto column = directions.col(order[std::size_t(i)]);
      axes.col(i) = column[i] < Real(-1e-6) ? Vec3(-column) : Vec3(column);
    }
    if (axes.col(0).cross(axes.col(1)).dot(axes.col(2)) < 0) {
      int least = 0;
      axes.diagonal().cwiseAbs().minCoeff(&least);
      axes.col(least) *= -1;
    }
    if (axes.trace() > most_alike + Real(1e-6)) {
      most_alike = axes.trace();
      best = axes;
    }
  } while (std::next_permutation(order.begin(), order.end()));
  return best;
}

Mat3 principal_axes(const Mat3& inertia) {
  const Real nothing = 64 * std::numeric_limits<Real>::epsilon() * inertia.trace();
  const Real mixed = std::max({std::abs(inertia(0, 1)), std::abs(inertia(0, 2)), std::abs(inertia(1, 2))});
  if (mixed <= nothing) return Mat3::Identity();
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(inertia);
  const Vec3& moments = solver.eigenvalues();  // ascending
  // If two moments are equal, rounding would choose the directions perpendicular to the third axis.
  for (const int lone : {2, 0}) {
    if (std::abs(moments[1] - moments[2 - lone]) > 16 * nothing) continue;
    const Vec3 axis = solver.eigenvectors().col(lone).normalized();
    const auto [across, over] = tangents_of(axis);
    Mat3 directions;
    directions << axis, across, over;
    return named(directions);
  }
  return named(solver.eigenvectors());
}

}  // namespace

PlacedSolid solid_of(const std::vector<Vec3>& points) {
  if (points.size() < 4 || points.size() > std::size_t(most_corners)) {
    throw InvalidInput(
        fmt::format("number of points of a hull is {}: from 4 to {} are needed", points.size(), most_corners));
  }
  Vec3 middle = Vec3::Zero();
  Real largest = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    require_finite(fmt::format("point {} of a hull", i), points[i]);
    middle += points[i] / Real(points.size());
    largest = std::max(largest, points[i].norm());
  }
  // Relative to a point inside, because far from the origin the moments would cancel to a few digits.
  std::vector<Vec3> moved;
  for (const Vec3& p : points) moved.push_back(p - middle);
  const std::vector<std::vector<int>> faces = faces_around(moved);
  const Moments moments = moments_of(polyhedron(moved, faces));
  const Mat3 axes = principal_axes(moments.inertia_per_kilogram);
  for (Vec3& p : moved) p = (axes.transpose() * (p - moments.centre)).eval();
  Polyhedron solid = polyhedron(moved, faces);
  solid.volume = moments.volume;
  solid.rounding = rounding_of(largest);
  const Mat3 turned = axes.transpose() * moments.inertia_per_kilogram * axes;
  return {std::make_shared<const Polyhedron>(std::move(solid)), middle + moments.centre, axes, turned.diagonal()};
}

}  // namespace pushback
