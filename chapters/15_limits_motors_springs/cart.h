/// A cart on three driven wheels, and the slope that it climbs.
#pragma once

#include <array>

#include "pushback/chapters/13_joints/hinge.h"
#include "pushback/chapters/15_limits_motors_springs/motor.h"
#include "pushback/common/world/situations.h"

namespace pushback::limits_motors_springs_scenes {

struct Cart {
  int chassis;
  std::array<int, 3> wheels;  // index 0: in front
};

inline constexpr Real cart_wheel = Real(0.25);                 // m, radius
inline constexpr Real chassis_mass = 20, cart_wheel_mass = 2;  // kg
inline constexpr Real cart_slope = 15;                         // degrees
inline constexpr Real cart_speed = 8;                          // rad/s, of its wheels

/// The wheels are balls on hinges. There are three, because the loads of four would be indeterminate. The cart stands on a plane
/// through the origin that rises by `slope` rad along +x. The middle of its axles is `along` m up the slope.
inline Cart add_cart(World& world, Real slope, Real along) {
  const Quat turn(Eigen::AngleAxis<Real>(slope, Vec3::UnitZ()));
  const Vec3 middle = turn * Vec3(along, cart_wheel, 0);
  const auto add = [&](Body body, const Vec3& at, int colour) {
    return world.add(body.oriented(turn).at(middle + turn * at).coloured(colour));
  };
  Cart cart{};
  cart.chassis = add(box({Real(0.5), Real(0.12), Real(0.3)}, chassis_mass), {0, Real(0.1), 0}, 1);
  const std::array<Vec3, 3> axles{Vec3(Real(0.8), 0, 0), Vec3(Real(-0.4), 0, Real(0.6)),
                                  Vec3(Real(-0.4), 0, Real(-0.6))};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3& axle = axles[i];
    cart.wheels[i] = add(sphere(cart_wheel, cart_wheel_mass).rough(1), axle, 4);
    Joint axis = hinge(world, cart.chassis, cart.wheels[i], middle + turn * axle, Vec3::UnitZ());
    axis.line = [](const Body&, const Body& wheel) {  // a diameter on its outside, which shows the rotation
      const Real side = wheel.position.z() < Real(-0.1) ? -1 : 1;
      const Vec3 at = wheel.position + Vec3(0, 0, side * cart_wheel);
      const Vec3 out = wheel.orientation * Vec3(Real(0.8) * cart_wheel, 0, 0);
      return std::vector<Vec3>{at - out, at + out};
    };
    world.joints.push_back(axis);
  }
  return cart;
}
/// Adds a motor of `speed` rad/s and `torque` N m for each wheel. Forwards is +x, a rotation about -z.
inline void drive(World& world, const Cart& cart, Real speed, Real torque) {
  for (const int wheel : cart.wheels) {
    world.joints.push_back(motor_at_speed(world, cart.chassis, wheel, -Vec3::UnitZ(), speed, torque));
  }
}
/// The acceleration up the slope, m/s^2, while the wheels roll and the motors apply their full torque:
///
///   a = (3 tau / R - m g sin) / (m + 3 I / R^2),   I = 2/5 m_w R^2
inline Real acceleration_of_cart(Real slope, Real torque) {
  const Real mass = chassis_mass + 3 * cart_wheel_mass;
  return (3 * torque / cart_wheel - mass * World::g * std::sin(slope)) / (mass + 3 * Real(0.4) * cart_wheel_mass);
}

}  // namespace pushback::limits_motors_springs_scenes
