/// A bullet and a sheet, a rod and a wall, balls in a row, and a pendulum and a wall, all with known motions.
#pragma once

#include "pushback/chapters/13_joints/ball_and_socket.h"
#include "pushback/chapters/19_accuracy_and_time/truth.h"
#include "pushback/common/world/situations.h"

namespace pushback::moment_of_impact_scenes {

/// A ball of 10 mm that flies at a fixed sheet of 1 mm. No gravity.
struct Bullet {
  Real speed = 500, e = Real(0.008);  // m/s, and restitution of the pair

  static constexpr Real radius = Real(0.005), thickness = Real(0.001), from = Real(-0.06), height = Real(0.06);

  static constexpr Real stops_at = -thickness / 2 - radius;  // m: x of the centre when the ball meets the sheet
  void operator()(World& world) const {
    world.gravity.setZero();
    world.add(box({thickness / 2, height / 2, height / 2}, 1).fixed().coloured(3));
    world.add(sphere(radius, Real(0.01)).at({from, 0, 0}).moving({speed, 0, 0}).bouncy(e).coloured(0));
  }
  /// x of its centre after t s, m.
  Real place(Real t) const {
    const Real meets = (stops_at - from) / speed;
    return t < meets ? from + speed * t : stops_at - e * speed * (t - meets);
  }
};

/// A rod that spins about its middle next to a wall of 1 mm, which its end meets. No gravity, no friction, e = 1.
struct SpinningRod {
  Real spin = 12;  // rad/s

  static constexpr Real half = Real(0.5), radius = Real(0.02), wall = Real(0.4), thickness = Real(0.001);  // m

  static Body rod() { return capsule(radius, half, 1).rough(0).bouncy(1).coloured(1); }
  void operator()(World& world) const {
    world.gravity.setZero();
    world.add(box({thickness / 2, Real(0.7), Real(0.25)}, 1).fixed().at({wall + thickness / 2, 0, 0}).coloured(3));
    world.add(rod().spinning({0, 0, -spin}));
  }
  /// The angle from upright when it meets the wall, rad, and the time, s.
  Real angle() const { return std::asin((wall - radius) / half); }
  Real meets() const { return angle() / spin; }
  /// Its pose after t s. The wall's impulse J acts along -x, at r = half cos(angle) above the middle:
  ///   J (1/m + r^2 / I) = (1 + e) r spin
  Body truth(Real t) const {
    const Real since = t - meets();
    if (since < 0) return rod().turned(-spin * t, Vec3::UnitZ());
    const Body body = rod();
    const Real r = half * std::cos(angle()), per_inertia = body.principal_inverse_inertia.z();
    const Real push = 2 * r * spin / (body.inverse_mass + r * r * per_inertia);
    return rod()
        .turned(-angle() + since * (push * r * per_inertia - spin), Vec3::UnitZ())
        .at({-since * push * body.inverse_mass, 0, 0});
  }
  /// The distance by which an end is beyond the wall, m.
  static Real beyond(const World& world) {
    const Body& body = world.bodies[1];
    return body.position.x() + half * std::abs((body.orientation * Vec3::UnitY()).x()) + radius - wall;
  }
};

/// A ball on links, or directly on a pin, that swings to a smooth wall. Released at rest, all in one line.
struct PendulumAtWall {
  int links = 1;
  Real e = Real(0.8), wall = Real(0.3);  // m

  static constexpr Real radius = Real(0.2), mass = 2;                              // of the ball, m, kg
  static constexpr Real link = Real(0.5), half_width = Real(0.02), link_mass = 1;  // of a link
  static constexpr Real angle = -pi / 3;

  static Body ball() { return sphere(radius, mass).rough(0); }
  static Body rod() { return box({half_width, link / 2, half_width}, link_mass).rough(0); }
  static Vec3 down() { return {std::sin(angle), -std::cos(angle), 0}; }
  /// Adds the bodies: the links, the ball, the wall.
  void fill(World& world) const {
    for (int i = 0; i < links; ++i)
      world.add(rod().turned(angle, Vec3::UnitZ()).at((static_cast<Real>(i) + Real(0.5)) * link * down()).bouncy(e));
    world.add(ball().at((static_cast<Real>(links) * link + radius) * down()).bouncy(e));
    world.add(half_space(-Vec3::UnitX()).at({wall, 0, 0}).rough(0).bouncy(e));
  }
  std::vector<Pin> pins() const {
    std::vector<Pin> all;
    for (int i = 0; i <= links; ++i)
      all.push_back({i == 0 ? the_world : i - 1, i, static_cast<Real>(i) * link * down()});
    return all;
  }
  void operator()(World& world) const {
    fill(world);
    for (const Pin& pin : pins()) world.joints.push_back(ball_and_socket(world, pin.a, pin.b, pin.anchor));
  }
  std::vector<Places> truth(int frames) const {
    std::vector<truth::Hanging> bodies;
    for (int i = 0; i <= links; ++i) {
      const Body body = i < links ? rod() : ball();
      bodies.push_back({.mass = 1 / static_cast<double>(body.inverse_mass),
                        .inertia = 1 / static_cast<double>(body.principal_inverse_inertia.z()),
                        .to_centre = static_cast<double>(i < links ? link / 2 : radius),
                        .to_next = static_cast<double>(link)});
    }
    const truth::Wall at{static_cast<double>(wall), static_cast<double>(radius), static_cast<double>(e)};
    std::vector<Places> found = truth::places_of_hanging(bodies, static_cast<double>(angle), frames, at);
    for (Places& places : found) places.emplace_back(static_cast<double>(wall), 0, 0);
    return found;
  }
};

/// Five balls in a row. The last four touch, and the first arrives at 5 m/s. No gravity, e = 1.
inline void cradle(World& world) {
  world.gravity.setZero();
  for (int i = 0; i < 5; ++i)
    world.add(sphere(Real(0.5), 1).at({static_cast<Real>(i) - (i == 0 ? Real(0.05) : 0), 0, 0}).rough(0).bouncy(1));
  world.bodies[0].velocity.x() = 5;
}

}  // namespace pushback::moment_of_impact_scenes
