/// A bar and its stop, a bar that follows sin t, two winches, three springs, two pulleys, a swing.
#pragma once

#include "pushback/chapters/13_joints/hinge.h"
#include "pushback/chapters/14_joints_under_load/jointed_solver.h"
#include "pushback/chapters/15_limits_motors_springs/limits.h"
#include "pushback/chapters/15_limits_motors_springs/motor.h"
#include "pushback/chapters/15_limits_motors_springs/piston.h"
#include "pushback/chapters/15_limits_motors_springs/spring.h"
#include "pushback/chapters/15_limits_motors_springs/wound_rope.h"
#include "pushback/common/world/situations.h"

namespace pushback::limits_motors_springs_scenes {

/// Shows the end of an axle as a fixed ball, which no body reaches.
inline void axle(World& world, const Vec3& at) {
  world.add(sphere(Real(0.05), 1).fixed().at(at + Vec3(0, 0, Real(0.14))));
}

// ---- a bar and its stop ------------------------------------------------------------------------------------------------

inline constexpr Real bar_half = Real(0.75);        // m
inline constexpr Real bar_lifted = -80 * pi / 180;  // rad from straight down
inline constexpr Real bar_stop = 30;                // degrees

/// Body 0 hangs from a hinge and is released on one side. A fixed plate behind it marks the stop, at `stop_at` degrees.
inline void bar_and_stop(World& world, Real stop_at = bar_stop) {
  const auto along = [](Real angle) { return Vec3(std::sin(angle), -std::cos(angle), 0); };
  const int bar = world.add(box({Real(0.07), bar_half, Real(0.07)}, 5)
                                .turned(bar_lifted, Vec3::UnitZ())
                                .at(bar_half * along(bar_lifted))
                                .coloured(3));
  world.joints.push_back(hinge(world, the_world, bar, Vec3::Zero(), Vec3::UnitZ()));
  const Real stop = stop_at * pi / 180;
  const Vec3 across(std::cos(stop), std::sin(stop), 0);
  world.add(box({Real(0.03), Real(0.35), Real(0.15)}, 1)
                .fixed()
                .turned(stop, Vec3::UnitZ())
                .at(Real(1.2) * along(stop) + Real(0.1) * across + Vec3(0, 0, Real(-0.3))));
  axle(world, Vec3::Zero());
}
inline Real angle_of_bar(const World& world) {  // degrees from straight down
  const Vec3& at = world.bodies[0].position;
  return std::atan2(at.x(), -at.y()) * 180 / pi;
}
inline Joint stop_of_bar(const World& world, Real stop_at = bar_stop) {
  return angle_limits(world, the_world, 0, Vec3::UnitZ(), -pi / 2, stop_at * pi / 180 - bar_lifted);
}
/// The mistake to avoid is a limit without lambda >= 0 within a degree of the stop.
inline Joint stop_that_sucks(const World& world, Real stop_at = bar_stop) {
  Joint stop = stop_of_bar(world, stop_at);
  stop.ask = [ask = stop.ask](const Body& a, const Body& b, const TimeStep& now, Equations& equations) {
    ask(a, b, now, equations);
    Equation& high = equations.back();
    if (high.bias * now.dt < pi / 180) high.lo = -std::numeric_limits<Real>::infinity();
  };
  return stop;
}

// ---- theta = sin t, with 10 N m ----------------------------------------------------------------------------------------

inline constexpr Real follow_torque = 10;                      // N m
inline constexpr Real light_pointer = 20, heavy_pointer = 80;  // kg
inline Real inertia_of_pointer(Real mass) {
  return mass * (bar_half * bar_half + Real(0.07) * Real(0.07)) / 3;
}
/// Body 0 is a bar on a hinge through its middle. Body 1 is a thin bar behind it, at the angle that body 0 should have. Each
/// variant sets the mass of body 0. `torque`: N m.
inline void pointers(World& world, Real torque) {
  const int pointer = world.add(box({bar_half, Real(0.07), Real(0.07)}, 1).coloured(3));
  const int wanted = world.add(box({1, Real(0.02), Real(0.02)}, 1).at({0, 0, Real(-0.2)}).coloured(0));
  for (const int body : {pointer, wanted}) {
    world.joints.push_back(hinge(world, the_world, body, world.bodies[std::size_t(body)].position, Vec3::UnitZ()));
  }
  for (Body& body : world.bodies) body.spinning({0, 0, 1});  // the derivative of sin t at t = 0
  const auto sine = [](Real t) { return std::sin(t); };
  world.joints.push_back(motor_to_angle(world, the_world, wanted, Vec3::UnitZ(), sine, 1000));
  world.joints.push_back(motor_to_angle(world, the_world, pointer, Vec3::UnitZ(), sine, torque));
  axle(world, Vec3::Zero());
}
inline void weigh_pointer(World& world, Real mass) {
  Body& pointer = world.bodies[0];
  pointer.inverse_mass = 1 / mass;
  pointer.principal_inverse_inertia /= mass;  // until now for 1 kg
  pointer.refresh_inertia();
}
inline Real angle_of_pointer(const World& world) {  // rad
  const Vec3 along = world.bodies[0].orientation * Vec3::UnitX();
  return std::atan2(along.y(), along.x());
}

// ---- wheels and ropes --------------------------------------------------------------------------------------------------

/// A disc with 16 corners on each side and its axis along z. Lengths in m, mass in kg.
inline Body disc(Real radius, Real half_width, Real mass) {
  std::vector<Vec3> corners;
  for (int i = 0; i < 16; ++i) {
    const Real angle = pi / 8 * (static_cast<Real>(i) + Real(0.5));
    for (const Real side : {Real(-1), Real(1)})
      corners.emplace_back(radius * std::cos(angle), radius * std::sin(angle), side * half_width);
  }
  return hull(corners, mass);
}
/// The moment of inertia about the world z axis, kg m^2.
inline Real inertia_of_disc(const Body& disc) {
  return 1 / (disc.inverse_inertia * Vec3::UnitZ()).z();
}
/// The same joint with a diameter drawn on the front of the wheel, the joint's body b, to show its rotation.
inline Joint with_spoke(Joint joint, Real radius, Real front) {
  joint.line = [=](const Body&, const Body& wheel) {
    const Vec3 at = wheel.position + Vec3(0, 0, front), out = wheel.orientation * (radius * Vec3::UnitX());
    return std::vector<Vec3>{at - out, at + out};
  };
  return joint;
}
/// Adds a wheel on a hinge to the world. Returns its index.
inline int wheel_at(World& world, const Vec3& at, Real radius, Real mass) {
  const int wheel = world.add(disc(radius, Real(0.08), mass).at(at).coloured(4));
  world.joints.push_back(with_spoke(hinge(world, the_world, wheel, at, Vec3::UnitZ()), radius, Real(0.1)));
  return wheel;
}
/// Adds a cube that hangs from the wheel by a rope wound on it at `radius` m: `below` m below the axle, on its side +x or -x
/// (`side`), `front` m in front of the middle of the wheel. Returns its index.
inline int hang(World& world, int wheel, Real radius, int side, Real mass, Real below, int colour, Real front = 0) {
  const Vec3 axle_at = world.bodies[std::size_t(wheel)].position;
  // Volatile: for a compile-time constant, the rounding of the root by g++ would depend on inlining.
  const volatile Real volume = mass / 1000;
  const Real half = std::cbrt(volume) * Real(1.2);
  const Vec3 hook = axle_at + Vec3(static_cast<Real>(side) * radius, -below, front);
  const int load = world.add(box(Vec3::Constant(half), mass).at(hook - Vec3(0, half, 0)).coloured(colour));
  world.joints.push_back(wound_rope(world, wheel, axle_at, Vec3::UnitZ(), radius,
                                    side > 0 ? Winding::forwards : Winding::backwards, load, hook));
  return load;
}

inline constexpr Real winch_radius = Real(0.25);  // m
inline constexpr Real winch_speed = 2;            // rad/s
inline constexpr Real winch_torque = 5;           // N m
inline constexpr Real light_load = Real(1.5);     // kg

/// Adds a winch with its motor at `x` m, and its load of `load` kg as the next body.
inline void winch(World& world, Real x, Real load) {
  const int wheel = wheel_at(world, {x, 3, 0}, winch_radius, 10);
  hang(world, wheel, winch_radius, 1, load, Real(1.4), load < 2 ? 0 : 3);
  world.joints.push_back(motor_at_speed(world, the_world, wheel, Vec3::UnitZ(), winch_speed, winch_torque));
}
struct TwoWinches {
  Real heavy_load = Real(2.5);  ///< kg

  void operator()(World& world) const {
    winch(world, -1, light_load);  // bodies 0 and 1
    winch(world, 1, heavy_load);   // bodies 2 and 3
  }
  /// The upward acceleration of the heavy load, m/s^2, while the motor applies its full torque:   R (torque - m g R) / (I + m R^2)
  Real acceleration() const {
    World world;
    (*this)(world);
    const Real R = winch_radius, m = heavy_load;
    return R * (winch_torque - m * World::g * R) / (inertia_of_disc(world.bodies[2]) + m * R * R);
  }
};

inline constexpr Real pulley_radius = Real(0.4), inner_radius = Real(0.2);  // m

/// Atwood's machine, bodies 0 to 2, and a wheel with two radii, bodies 3 to 5, on which the lighter load sinks.
struct TwoPulleys {
  Real light = 2, heavy = 3;  ///< kg, on each wheel; on the stepped one the heavy load hangs from the inner radius

  void operator()(World& world) const {
    const int plain = wheel_at(world, {-1, 3, 0}, pulley_radius, 2);
    hang(world, plain, pulley_radius, -1, light, Real(1.3), 0);
    hang(world, plain, pulley_radius, 1, heavy, Real(1.3), 3);
    const int stepped = wheel_at(world, {1, 3, 0}, pulley_radius, 2);
    hang(world, stepped, inner_radius, -1, heavy, Real(1.3), 3, Real(0.12));
    hang(world, stepped, pulley_radius, 1, light, Real(1.3), 0);
  }
  /// The downward acceleration of the heavy load of Atwood's machine, m/s^2:   (m1 - m2) g / (m1 + m2 + I / R^2)
  Real acceleration_of_atwood() const {
    return (heavy - light) * World::g / (heavy + light + inertia_of_wheel(0) / (pulley_radius * pulley_radius));
  }
  /// The downward acceleration of the load on the outer radius, m/s^2:   R (m_o R - m_i r) g / (I + m_o R^2 + m_i r^2)
  Real acceleration_of_stepped() const {
    const Real R = pulley_radius, r = inner_radius;
    return R * (light * R - heavy * r) * World::g / (inertia_of_wheel(3) + light * R * R + heavy * r * r);
  }

 private:
  Real inertia_of_wheel(std::size_t body) const {
    World world;
    (*this)(world);
    return inertia_of_disc(world.bodies[body]);
  }
};

// ---- springs -----------------------------------------------------------------------------------------------------------

inline constexpr Real spring_length = Real(1.2), pulled_by = Real(0.6);  // m

/// C(t) of a spring of angular frequency w (rad/s) that is released at rest at C = c0:   C'' + 2 zeta w C' + w^2 C = 0
inline Real let_go(Real c0, Real w, Real zeta, Real t) {
  if (zeta == 1) return c0 * (1 + w * t) * std::exp(-w * t);
  if (zeta < 1) {
    const Real swing = w * std::sqrt(1 - zeta * zeta);
    return c0 * std::exp(-zeta * w * t) * (std::cos(swing * t) + zeta * w / swing * std::sin(swing * t));
  }
  const Real root = w * std::sqrt(zeta * zeta - 1), slow = root - zeta * w, fast = -root - zeta * w;
  return c0 * (slow * std::exp(fast * t) - fast * std::exp(slow * t)) / (slow - fast);
}

/// Balls, the first bodies, each pulled down on its spring, without gravity. A thin fixed bar marks where they come to rest.
struct SpringsLetGo {
  Real hertz = 1;
  std::vector<Real> damping_ratios{Real(0.1), 1, 5};

  void operator()(World& world) const {
    world.gravity.setZero();
    const Real middle = static_cast<Real>(damping_ratios.size() - 1) / 2, half = middle + Real(0.5);
    for (std::size_t i = 0; i < damping_ratios.size(); ++i) {
      const Real x = static_cast<Real>(i) - middle;
      const Vec3 hook(x, 3, 0), at(x, 3 - spring_length - pulled_by, 0);
      const int ball = world.add(sphere(Real(0.18), 2).at(at).coloured(static_cast<int>(i)));
      const Spring spring{hertz, damping_ratios[i]};
      world.joints.push_back(soft(distance(world, the_world, hook, ball, at, spring_length), spring));
    }
    world.add(box({half, Real(0.05), Real(0.15)}, 1).fixed().at({0, Real(3.05), 0}));
    world.add(box({half, Real(0.01), Real(0.01)}, 1).fixed().at({0, 3 - spring_length, Real(-0.3)}));
  }
  /// The distance of the ball with the i-th damping ratio below its rest position, m.
  Real below(const World& world, std::size_t i) const { return 3 - spring_length - world.bodies[i].position.y(); }
  Real closed_form(std::size_t i, Real t) const { return let_go(pulled_by, 2 * pi * hertz, damping_ratios[i], t); }
};

// ---- a swing that is pumped --------------------------------------------------------------------------------------------

inline constexpr Real swing_length = 2;                                  // m
inline constexpr Real swing_start = Real(0.05);                          // rad
inline const Real swing_frequency = std::sqrt(World::g / swing_length);  // rad/s

/// Body 0, a ball on a rod that shortens and lengthens by the fraction `pump` of its length, twice per swing:
///
///   L(t) = L (1 + pump sin(2 w t)):  short at the bottom, long at the turning points
inline void pumped_swing(World& world, Real pump) {
  const Vec3 at(swing_length * std::sin(swing_start), -swing_length * std::cos(swing_start), 0);
  const int ball = world.add(sphere(Real(0.1), 1).at(at));
  world.joints.push_back(piston(world, the_world, Vec3::Zero(), ball, at, [pump](Real t) {
    return swing_length * (1 + pump * std::sin(2 * swing_frequency * t));
  }));
}
inline Real angle_of_swing(const World& world) {  // rad from straight down
  const Vec3& at = world.bodies[0].position;
  return std::atan2(at.x(), -at.y());
}

}  // namespace pushback::limits_motors_springs_scenes
