/// The scalar type, and the small vectors and matrices.
///
/// Units are SI. The legend of symbols is docs/notation.md.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace pushback {

#ifdef PUSHBACK_FLOAT
using Real = float;
#else
using Real = double;
#endif

using Vec3 = Eigen::Matrix<Real, 3, 1>;
using Mat3 = Eigen::Matrix<Real, 3, 3>;
using Quat = Eigen::Quaternion<Real>;

inline constexpr Real pi = Real(3.14159265358979323846);

/// (q) x (r) = [q]_x r, the cross product as a matrix.
inline Mat3 skew(const Vec3& q) {
  Mat3 m;
  m << 0, -q.z(), q.y(), q.z(), 0, -q.x(), -q.y(), q.x(), 0;
  return m;
}

/// Two unit vectors that with the unit vector n form a right-handed orthonormal basis (n, t1, t2).
struct Tangents {
  Vec3 tangent1, tangent2;
};

/// t1 is the projection, to the plane perpendicular to n, of the world axis with the smallest component along n. The tangents
/// depend only on n, so a box that slides on the ground keeps its tangents.
inline Tangents tangents_of(const Vec3& n) {
  int flattest = 0;
  n.cwiseAbs().minCoeff(&flattest);
  const Vec3 axis = Vec3::Unit(flattest);
  const Vec3 tangent1 = (axis - n.dot(axis) * n).normalized();
  return {tangent1, n.cross(tangent1)};
}

}  // namespace pushback
