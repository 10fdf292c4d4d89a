/// A motor is a constraint with limited force.
#pragma once

#include "pushback/chapters/15_limits_motors_springs/angle.h"

namespace pushback {

/// Limits an equation to +-torque, N m. The limits of its row are h times as large, because they are impulses:
/// |sum(lambda)| <= h torque.
inline Equation with_torque(Equation row, Real torque) {
  row.lo = -torque;
  row.hi = torque;
  return row;
}

/// A motor of a hinge, which turns B relative to A to the angle `angle_at(t)`, rad, counted from the current poses.
///
///   C = theta - f(t),   C' = theta' + b,   b = -(f(t + h) - f(t)) / h
///
/// b is the mean of -f' over the step, not its value at one time, so that a step that starts with C = 0 ends with C = 0 for any
/// f. The angle is known only up to whole turns, so C takes the shorter way. Torque: N m. Catto, GDC 2009, with f = sin and
/// torque = 10.
inline Joint motor_to_angle(const World& world, int a, int b, const Vec3& axis, std::function<Real(Real)> angle_at,
                            Real torque) {
  const std::string name = "a motor";
  check_joined(world, name, a, b);
  require_not_negative("torque of " + name, torque);
  if (!angle_at) throw InvalidInput(name + " has no angle to reach: a function of time is needed");
  const HingeAngle angle(world, a, b, unit_axis(name, axis));
  const auto ask = [=](const Body& first, const Body& second, const TimeStep& now, Equations& equations) {
    const Angle turned = angle.of(first, second);
    const Real begin = angle_at(now.time), end = angle_at(now.time + now.dt);
    require_finite("angle that a motor is to reach", end);
    Equation row = with_torque(turning(turned.gradient), torque);
    row.error = std::remainder(turned.value - begin, 2 * pi);
    row.bias = -(end - begin) / now.dt;
    equations.push_back(row);
  };
  Joint motor{name, a, b, ask};
  motor.driven = true;
  return motor;
}

/// A motor of a hinge, which turns B relative to A at `speed`, rad/s, at any angle.
///
///   C' = omega - speed:   b = -speed
///
/// Torque: N m. Catto, GDC 2009, with speed = 2 and torque = 5. With speed = 0 the motor is a brake, which acts like friction.
inline Joint motor_at_speed(const World& world, int a, int b, const Vec3& axis, Real speed, Real torque) {
  const std::string name = "a motor";
  check_joined(world, name, a, b);
  require_finite("speed of " + name, speed);
  require_not_negative("torque of " + name, torque);
  const Vec3 on_a = body_of(world, a).orientation.conjugate() * unit_axis(name, axis);
  const auto ask = [=](const Body& first, const Body&, const TimeStep&, Equations& equations) {
    Equation row = with_torque(turning(first.orientation * on_a), torque);
    row.bias = -speed;
    equations.push_back(row);
  };
  Joint motor{name, a, b, ask};
  motor.driven = true;
  return motor;
}

}  // namespace pushback
