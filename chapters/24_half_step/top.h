/// A top whose motion is known.
#pragma once

#include "pushback/chapters/13_joints/ball_and_socket.h"
#include "pushback/common/world/world.h"

namespace pushback::half_step_scenes {

/// A disc on a stem that spins on a pin at the origin, its axis at `tilt` (rad) from the vertical. It precesses steadily:
///
///   I_p cos(tilt) W^2 - I_3 s W + m g l = 0        I_p: across the axis, about the pin;  s: the spin, about the axis
///
/// so the precession W determines the spin. The axis moves on a cone, and the disc does not nutate.
struct Top {
  Real tilt = pi / 4;
  Real precession = 2;  ///< W, rad/s

  static constexpr Real mass = 1, stem = Real(0.6);  // kg, and l from the pin to the centre, m
  static constexpr Real half_width = Real(0.4), half_height = Real(0.05);

  static Body disc() { return box({half_width, half_height, half_width}, mass); }
  /// The spin s, rad/s.
  Real spin() const {
    const Vec3 inertia = disc().principal_inverse_inertia.cwiseInverse();
    const Real about_pin = inertia.x() + mass * stem * stem;
    return (about_pin * std::cos(tilt) * precession * precession + mass * World::g * stem) / (inertia.y() * precession);
  }
  /// The direction of its axis after t s, unit.
  Vec3 axis(Real t) const {
    const Real angle = precession * t;
    return {std::sin(tilt) * std::cos(angle), std::cos(tilt), -std::sin(tilt) * std::sin(angle)};
  }
  void operator()(World& world) const {
    const Vec3 up = Vec3::UnitY(), along = axis(0);
    // The angular velocity: s about the axis, and W about the vertical without its component along the axis, which s contains.
    const Vec3 turning = spin() * along + precession * (up - up.dot(along) * along);
    const int top = world.add(disc()
                                  .turned(-tilt, Vec3::UnitZ())
                                  .at(stem * along)
                                  .moving(turning.cross(stem * along))
                                  .spinning(turning)
                                  .coloured(2));
    world.joints.push_back(ball_and_socket(world, the_world, top, Vec3::Zero()));
  }
};

}  // namespace pushback::half_step_scenes
