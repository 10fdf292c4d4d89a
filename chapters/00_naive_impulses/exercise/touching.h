/// What exercises 00 and 01 look at: two bodies that touch at one point, the origin.
#pragma once

#include "pushback/common/bodies/random.h"
#include "pushback/common/world/world.h"

namespace pushback::exercise_00 {

/// Body A below, body B above, before anything is turned. They have no weight.
struct Touching {
  World world;

  Contact& contact() { return world.contacts[0]; }
  Real separates() { return separating_speed(world, contact()); }  ///< m/s, at the point
  Real spin(std::size_t body) const { return world.bodies[body].angular_velocity.norm(); }
  Real along_n(std::size_t body) { return world.bodies[body].velocity.dot(contact().normal); }  ///< m/s, of its centre

  void touch(const Vec3& normal, Real restitution) {
    world.gravity.setZero();
    world.contacts = {{.normal = normal, .restitution = restitution, .id = {0, 1, 0}}};
  }
};

/// Two balls whose centres separate at `leaving`, m/s. No impulse along the normal turns them.
struct TwoBalls : Touching {
  TwoBalls(Random& random, Real leaving, Real restitution) {
    const Vec3 normal = random.direction();
    const Real together = random.between(1, 2);  // m/s, of both along n
    for (const Real side : {Real(-1), Real(1)}) {
      const Real radius = random.between(Real(0.2), Real(0.5)), mass = random.between(5, 20);
      world.add(sphere(radius, mass).at(side * radius * normal).moving((together + side * leaving / 2) * normal));
    }
    touch(normal, restitution);
  }
};

/// The end of a bar lies on the end of another one. Where they spin, both spins add to the separating speed or both take from
/// it, by less than 2 m/s in all.
struct TwoBars : Touching {
  enum class Spin { none, some };
  enum class Axes { of_the_world, turned };

  TwoBars(Random& random, Real leaving, Real restitution, Spin spins = Spin::none, Axes axes = Axes::of_the_world) {
    const Quat turn = axes == Axes::turned ? random.orientation() : Quat::Identity();
    const Real sign = random.below(2) == 0 ? Real(1) : Real(-1);
    for (const Real side : {Real(-1), Real(1)}) {
      const Vec3 half{random.between(Real(0.6), Real(0.9)), random.between(Real(0.1), Real(0.15)),
                      random.between(Real(0.2), Real(0.3))};
      const Vec3 to_the_point{side * random.between(Real(0.3), Real(0.55)), -side * half.y(),
                              random.between(Real(-0.1), Real(0.1))};
      Vec3 velocity = random.vector(1), spin = Vec3::Zero();
      velocity.y() = side * leaving / 2;
      if (spins == Spin::some)
        spin = {random.between(Real(-0.5), Real(0.5)), random.between(-2, 2),
                sign * random.between(Real(0.8), Real(1.4))};
      Body bar =
          box(half, random.between(5, 20)).at(turn * Vec3(-to_the_point)).moving(turn * velocity).spinning(turn * spin);
      bar.orientation = turn;
      world.add(bar);
    }
    for (Body& body : world.bodies) body.refresh_inertia();
    touch(turn * Vec3::UnitY(), restitution);
  }
};

}  // namespace pushback::exercise_00
