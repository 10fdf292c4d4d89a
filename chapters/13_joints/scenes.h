/// Beads on wires, pendulums, a door.
#pragma once

#include "pushback/chapters/13_joints/distance.h"
#include "pushback/chapters/13_joints/weld.h"
#include "pushback/chapters/13_joints/wire.h"
#include "pushback/common/world/situations.h"

namespace pushback::joints_scenes {

// ---- beads on wires ----------------------------------------------------------------------------------------------------

/// An ellipse with the half axes a and b (m) about (x0, y0), or a ring if a = b.
///
///   C = ((x - x0)^2 / a^2 + (y - y0)^2 / b^2 - 1) / 2,   grad C = ((x - x0) / a^2, (y - y0) / b^2)
inline Wire ellipse(Real x0, Real y0, Real a, Real b) {
  Wire wire;
  wire.c = [=](Real x, Real y) { return ((x - x0) * (x - x0) / (a * a) + (y - y0) * (y - y0) / (b * b) - 1) / 2; };
  wire.gradient = [=](Real x, Real y) { return Vec3((x - x0) / (a * a), (y - y0) / (b * b), 0); };
  for (int i = 0; i <= 48; ++i) {
    const Real angle = 2 * pi * static_cast<Real>(i) / 48;
    wire.drawn.push_back({x0 + a * std::cos(angle), y0 + b * std::sin(angle), 0});
  }
  return wire;
}
/// Two valleys and a hill of height `hill` (m) between them, drawn from x0 - 1.5 w to x0 + 1.5 w.
///
///   C = y - f(x),   f = y0 + hill ((x - x0)^2 / w^2 - 1)^2,   grad C = (-f', 1)
inline Wire two_valleys(Real x0, Real y0, Real w, Real hill) {
  Wire wire;
  const auto slope = [=](Real x) { return (x - x0) * (x - x0) / (w * w) - 1; };
  const auto f = [=](Real x) { return y0 + hill * slope(x) * slope(x); };
  wire.c = [=](Real x, Real y) { return y - f(x); };
  wire.gradient = [=](Real x, Real) { return Vec3(-4 * hill * slope(x) * (x - x0) / (w * w), 1, 0); };
  for (int i = -24; i <= 24; ++i) {
    const Real x = x0 + Real(1.5) * w * static_cast<Real>(i) / 24;
    wire.drawn.push_back({x, f(x), 0});
  }
  return wire;
}

/// Three beads, near the top of a ring, near the top of an ellipse, and near the end of a wire with two valleys.
inline void beads_on_wires(World& world) {
  const auto bead = [&world](const Wire& wire, const Vec3& at) {
    const int body = world.add(sphere(Real(0.17), 1).at(at));
    world.joints.push_back(bead_on(world, wire, body));
  };
  const Real lean = Real(0.35);  // rad from the top
  bead(ellipse(-3, 0, 1, 1), {-3 + std::sin(lean), std::cos(lean), 0});
  bead(ellipse(0, 0, Real(1.4), Real(0.8)), {Real(1.4) * std::sin(lean), Real(0.8) * std::cos(lean), 0});
  const Wire valleys = two_valleys(3, -1, 1, Real(1.1));
  bead(valleys, valleys.drawn[2]);
}

// ---- pendulums ---------------------------------------------------------------------------------------------------------

inline constexpr Real rod_length = Real(1.5);      // m
inline constexpr Real half_plank = Real(0.75);     // m
inline constexpr Real plank_width = Real(0.08);    // m, half the width
inline constexpr Real ball_at = -2, plank_at = 2;  // m, x of their pivots

/// A ball on a rod and a plank on a hinge at its end, released at rest.
struct Pendulums {
  Real released_at = Real(1.5);  ///< rad from straight down

  void operator()(World& world) const {
    const Vec3 hook(ball_at, 0, 0), pin(plank_at, 0, 0);
    const Vec3 way(std::sin(released_at), -std::cos(released_at), 0);
    const int ball = world.add(sphere(Real(0.2), 1).at(hook + rod_length * way));
    const int plank = world.add(box({plank_width, half_plank, plank_width}, 1)
                                    .turned(released_at, Vec3::UnitZ())
                                    .at(pin + half_plank * way)
                                    .coloured(3));
    world.joints = {distance(world, the_world, hook, ball, hook + rod_length * way),
                    hinge(world, the_world, plank, pin, Vec3::UnitZ())};
  }
  /// 4 sqrt(L / g) K(sin(theta_0 / 2)), s. For a body on a hinge L = I / (m d), with I about the hinge and d from the hinge to
  /// the centre of mass.
  /// The elliptic integral is K(k) = pi / (2 M), with the arithmetic-geometric mean M of 1 and sqrt(1 - k^2).
  Real period(Real length) const {
    Real mean = 1, other = std::cos(released_at / 2);
    for (int i = 0; i < 6; ++i) {  // each round doubles the number of correct digits
      const Real before = mean;
      mean = (mean + other) / 2;
      other = std::sqrt(before * other);
    }
    return 2 * pi * std::sqrt(length / World::g) / mean;
  }
};
/// The angle from straight down, rad.
inline Real angle_of_ball(const World& world) {
  const Vec3& p = world.bodies[0].position;
  return std::atan2(p.x() - ball_at, -p.y());
}
inline Real angle_of_plank(const World& world) {
  const Vec3& p = world.bodies[1].position;
  return std::atan2(p.x() - plank_at, -p.y());
}
inline Real length_of_plank() {
  return half_plank + (half_plank * half_plank + plank_width * plank_width) / (3 * half_plank);
}

// ---- hinge and weld ----------------------------------------------------------------------------------------------------

/// A door on a hinge with a ball thrown at it, and two boxes welded together, which are also thrown.
inline void door_and_weld(World& world) {
  world.add(ground());
  const Real height = 1, half = Real(0.5);  // m, half extents
  for (const Real side : {Real(-1), Real(1)})
    world.add(box({Real(0.06), height + Real(0.08), Real(0.06)}, 1)
                  .fixed()
                  .at({-Real(1.5) + side * (half + Real(0.1)), height + Real(0.08), 0}));
  const int door = world.add(box({half, height, Real(0.03)}, 20).at({-Real(1.5), height + Real(0.05), 0}).coloured(3));
  world.joints.push_back(hinge(world, the_world, door, {-2, height, 0}, Vec3::UnitY()));
  world.add(sphere(Real(0.15), 3).at({-Real(1.2), Real(1.1), 3}).moving({0, 2, -9}).coloured(1));

  const Vec3 cube = Vec3::Constant(Real(0.25));
  const int one = world.add(box(cube, 10).at({1, 2, 0}).coloured(0)),
            other = world.add(box(cube, 10).at({Real(1.5), 2, 0}).turned(Real(0.6), Vec3::UnitX()).coloured(2));
  for (const int body : {one, other}) {
    Body& b = world.bodies[static_cast<std::size_t>(body)];
    b.moving({1, 2, 0}).spinning({1, 0, -3});
  }
  world.joints.push_back(weld(world, one, other, {Real(1.25), 2, 0}));
}

// ---- all of them -------------------------------------------------------------------------------------------------------

/// The largest |C| of all equations for the current poses: m, or rad for angular equations. Ignores lo and hi.
inline Real largest_joint_error(const World& world) {
  Real largest = 0;
  Equations equations;
  for (const Joint& joint : world.joints) {
    equations.clear();
    joint.ask(body_of(world, joint.a), body_of(world, joint.b), {world.time, Real(1) / 60}, equations);
    for (const Equation& equation : equations) largest = std::max(largest, std::abs(equation.error));
  }
  return largest;
}

}  // namespace pushback::joints_scenes
