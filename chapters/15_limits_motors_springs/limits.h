/// Joint limits: inequalities for angles.
#pragma once

#include "pushback/chapters/15_limits_motors_springs/angle.h"

namespace pushback {

/// C >= 0, by a force that is never negative, so the limit pushes but does not pull. `row` contains J.
///
///   C > 0:  b = C / h      in this step C may fall to 0
///   C <= 0: fed back like every error
inline Equation at_least_zero(Equation row, Real c, Real dt) {
  row.lo = 0;
  if (c > 0) row.bias = c / dt;
  else row.error = c;
  return row;
}

/// low <= angle <= high, rad. Adds both equations in every step, whether a limit is reached or not.
inline void between(const Angle& angle, Real low, Real high, Real dt, Equations& equations) {
  equations.push_back(at_least_zero(turning(angle.gradient), angle.value - low, dt));
  equations.push_back(at_least_zero(turning(-angle.gradient), high - angle.value, dt));
}

/// Throws InvalidInput unless the limits of an angle that is known up to whole turns are finite, in order and less than a turn
/// apart.
inline void check_limits(const std::string& joint, Real low, Real high) {
  require_finite("lower limit of " + joint, low);
  require_finite("upper limit of " + joint, high);
  if (low > high) {
    throw InvalidInput(fmt::format("limits of {} are {} and {}: the lower one has to come first", joint, low, high));
  }
  if (high - low >= 2 * pi) {
    throw InvalidInput(
        fmt::format("limits of {} are {} and {}: they have to be less than a turn, 2 pi, apart", joint, low, high));
  }
}

/// The same angle, shifted by whole turns to within half a turn of the middle of its limits.
inline Angle about_the_middle(Angle angle, Real low, Real high) {
  const Real middle = (low + high) / 2;
  angle.value = middle + std::remainder(angle.value - middle, 2 * pi);
  return angle;
}

/// Limits of an angle relative to the current poses, rad. `AngleBetween`: HingeAngle or TwistAngle.
template <class AngleBetween>
Joint limits_of(const std::string& name, const World& world, int a, int b, const Vec3& axis, Real low, Real high) {
  check_joined(world, name, a, b);
  check_limits(name, low, high);
  const AngleBetween angle(world, a, b, unit_axis(name, axis));
  const auto ask = [=](const Body& first, const Body& second, const TimeStep& now, Equations& equations) {
    between(about_the_middle(angle.of(first, second), low, high), low, high, now.dt, equations);
  };
  return {name, a, b, ask};
}

/// Limits of a hinge for the rotation of B relative to A about `axis` (world axes), from the current poses, rad.
inline Joint angle_limits(const World& world, int a, int b, const Vec3& axis, Real low, Real high) {
  return limits_of<HingeAngle>("angle limits", world, a, b, axis, low, high);
}

/// Limits of a ball and socket for the twist of B relative to A about `axis` (world axes), from the current poses, rad.
inline Joint twist_limits(const World& world, int a, int b, const Vec3& axis, Real low, Real high) {
  return limits_of<TwistAngle>("twist limits", world, a, b, axis, low, high);
}

/// A limit of a ball and socket, which keeps `of_b` within `angle` (rad, above 0, up to pi) of `of_a`, the axis of a cone.
/// Each direction is fixed in its body. Both are in world axes, for the current poses.
inline Joint cone_limit(const World& world, int a, int b, const Vec3& of_a, const Vec3& of_b, Real angle) {
  const std::string name = "a cone limit";
  check_joined(world, name, a, b);
  require_positive("angle of " + name, angle);
  require_between("angle of " + name, angle, 0, pi);
  const Vec3 s = body_of(world, a).orientation.conjugate() * unit_axis(name, of_a);
  const Vec3 u = body_of(world, b).orientation.conjugate() * unit_axis(name, of_b);
  const auto ask = [=](const Body& first, const Body& second, const TimeStep& now, Equations& equations) {
    const Angle off = swing(first.orientation * s, second.orientation * u);
    equations.push_back(at_least_zero(turning(-off.gradient), angle - off.value, now.dt));
  };
  return {name, a, b, ask};
}

}  // namespace pushback
