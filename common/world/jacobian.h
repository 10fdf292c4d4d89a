/// The Jacobian of contacts, friction and joints, which maps the velocities of two bodies to the speed of a constraint.
#pragma once

#include "pushback/common/bodies/body.h"

namespace pushback {

/// J = [ -n  -(r_A x n)  n  (r_B x n) ],   so that  C' = J V,   V = (v_A, w_A, v_B, w_B)
///
/// n is between the other two on purpose. If ra_n and rb_n were adjacent, g++ would store the third and fourth of their six
/// numbers together, and the construction of a row would wait until it can read them back as vectors.
struct Jacobian {
  Vec3 ra_n = Vec3::Zero();  ///< m; in a rotational row, the axis
  Vec3 n = Vec3::Zero();     ///< unit, world axes; 0 in a rotational row
  Vec3 rb_n = Vec3::Zero();  ///< m; as ra_n

  /// For the separation (P_B - P_A) . n. The points (m, world axes) are fixed to their bodies.
  static Jacobian along(const Vec3& n, const Body& a, const Vec3& point_a, const Body& b, const Vec3& point_b) {
    return {.ra_n = (point_a - a.position).cross(n), .n = n, .rb_n = (point_b - b.position).cross(n)};
  }
  /// The same if both points are at one place.
  static Jacobian along(const Vec3& n, const Body& a, const Body& b, const Vec3& point) {
    return along(n, a, point, b, point);
  }
  /// For the rotation (rad) of B relative to A about an axis.
  static Jacobian about(const Vec3& axis) { return {.ra_n = axis, .rb_n = axis}; }
};

}  // namespace pushback
