/// A bullet and a sheet, a rod and a wall, balls in a row: each with its closed form.
#pragma once

#include "pushback/common/world/world.h"

namespace pushback::moment_of_impact_scenes {

/// A ball of 10 mm that flies at a sheet of 1 mm, which does not move. No gravity.
struct Bullet {
  Real speed = 500, e = Real(0.008);  // m/s; of the pair

  static constexpr Real radius = Real(0.005), thickness = Real(0.001), from = Real(-0.06), height = Real(0.06);

  static constexpr Real stops_at = -thickness / 2 - radius;  // m: the centre, as it meets the sheet
  void operator()(World& world) const {
    world.gravity.setZero();
    world.add(box({thickness / 2, height / 2, height / 2}, 1).fixed().coloured(3));
    world.add(sphere(radius, Real(0.01)).at({from, 0, 0}).moving({speed, 0, 0}).bouncy(e).coloured(0));
  }
  /// Where its centre is, m.
  Real place(Real t) const {
    const Real meets = (stops_at - from) / speed;
    return t < meets ? from + speed * t : stops_at - e * speed * (t - meets);
  }
};

/// A rod that spins about its middle, beside a wall of 1 mm that its end meets. No gravity, no friction, e = 1.
struct SpinningRod {
  Real spin = 12;  // rad/s

  static constexpr Real half = Real(0.5), radius = Real(0.02), wall = Real(0.4), thickness = Real(0.001);  // m

  static Body rod() { return capsule(radius, half, 1).rough(0).bouncy(1).coloured(1); }
  void operator()(World& world) const {
    world.gravity.setZero();
    world.add(box({thickness / 2, Real(0.7), Real(0.25)}, 1).fixed().at({wall + thickness / 2, 0, 0}).coloured(3));
    world.add(rod().spinning({0, 0, -spin}));
  }
  /// rad, from upright, when it meets the wall; and s.
  Real angle() const { return std::asin((wall - radius) / half); }
  Real meets() const { return angle() / spin; }
  /// Where it is, and how it moves. The wall pushes with J along -x, at r = half cos(angle) above its middle:
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
  /// m: how far its upper end is beyond the wall.
  static Real beyond(const World& world) {
    const Body& body = world.bodies[1];
    return body.position.x() + half * std::abs((body.orientation * Vec3::UnitY()).x()) + radius - wall;
  }
};

/// Five balls that touch, and the first is hit: no gravity, e = 1.
inline void cradle(World& world) {
  world.gravity.setZero();
  for (int i = 0; i < 5; ++i)
    world.add(sphere(Real(0.5), 1).at({static_cast<Real>(i) - (i == 0 ? Real(0.05) : 0), 0, 0}).rough(0).bouncy(1));
  world.bodies[0].velocity.x() = 5;
}

}  // namespace pushback::moment_of_impact_scenes
