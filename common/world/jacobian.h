/// What contacts, friction and joints have in common: how the velocities of two bodies make the speed of a constraint.
#pragma once

#include "pushback/common/bodies/body.h"

namespace pushback {

/// J = [ -n  -(r_A x n)  n  (r_B x n) ],   so that  C' = J V,   V = (v_A, w_A, v_B, w_B)
///
/// n stands between the other two on purpose: of six numbers in a row g++ stores the third with the fourth, and a row that
/// is being made would wait until it can read them back as vectors.
struct Jacobian {
  Vec3 ra_n = Vec3::Zero();  ///< m; the axis, between turns
  Vec3 n = Vec3::Zero();     ///< unit, world axes; 0 between turns
  Vec3 rb_n = Vec3::Zero();  ///< m; as ra_n

  /// P_B - P_A along n. The points, m, world axes, ride on their bodies.
  static Jacobian along(const Vec3& n, const Body& a, const Vec3& point_a, const Body& b, const Vec3& point_b) {
    return {.ra_n = (point_a - a.position).cross(n), .n = n, .rb_n = (point_b - b.position).cross(n)};
  }
  /// Both bodies have their point at the same place.
  static Jacobian along(const Vec3& n, const Body& a, const Body& b, const Vec3& point) {
    return along(n, a, point, b, point);
  }
  /// The turn of B against A about an axis, rad.
  static Jacobian about(const Vec3& axis) { return {.ra_n = axis, .rb_n = axis}; }
};

}  // namespace pushback
