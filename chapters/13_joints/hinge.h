/// A hinge: five rows, which leave one rotation.
#pragma once

#include "pushback/chapters/13_joints/ball_and_socket.h"

namespace pushback {

/// Keeps a direction s fixed in A perpendicular to a direction u fixed in B. The error C is their deviation from a right
/// angle, measured about k, which is perpendicular to both:
///
///   tan C = s . u / |u x s|,   C' = (w_B - w_A) . k,   k = u x s / |u x s|
///
/// `s`, `u`: unit, world axes. C: rad.
inline Equation perpendicular(const Vec3& s, const Vec3& u) {
  const Vec3 across = u.cross(s);
  const Real sine = across.norm();
  const Vec3 k = sine > 0 ? Vec3(across / sine) : tangents_of(s).tangent1;  // if parallel, any axis across s
  return {.jacobian = Jacobian::about(k), .error = std::atan2(s.dot(u), sine)};
}

/// A ball and socket that turns about one axis only. `anchor` (m) and `axis`, which has any length but 0, are in world axes, for the
/// current poses.
inline Joint hinge(const World& world, int a, int b, const Vec3& anchor, const Vec3& axis) {
  check_joined(world, "a hinge", a, b);
  require_finite("anchor of a hinge", anchor);
  require_finite("axis of a hinge", axis);
  require_positive("length of the axis of a hinge", axis.norm());
  const Anchor there(world, a, b, anchor);
  const Vec3 along = axis.normalized();
  const Tangents across = tangents_of(along);
  const Quat to_a = body_of(world, a).orientation.conjugate(), to_b = body_of(world, b).orientation.conjugate();
  const Vec3 s1 = to_a * across.tangent1, s2 = to_a * across.tangent2, u = to_b * along;

  const auto ask = [=](const Body& first, const Body& second, const TimeStep&, Equations& equations) {
    there.ask(first, second, equations);
    const Vec3 turned = second.orientation * u;
    equations.push_back(perpendicular(first.orientation * s1, turned));
    equations.push_back(perpendicular(first.orientation * s2, turned));
  };
  return {"a hinge", a, b, ask};
}

}  // namespace pushback
