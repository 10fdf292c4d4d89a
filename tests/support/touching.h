/// Two bodies that touch somehow, for the tests.
#pragma once

#include "pushback/chapters/01_velocity_constraint/row.h"
#include "pushback/common/bodies/random.h"

namespace pushback {

/// Two bodies that move and spin, with masses over four decades, and a contact between them: a point somewhere, a normal in
/// any direction, up to 0.1 m deep.
struct RandomPair {
  World world;
  Contact contact;

  explicit RandomPair(Random& random) {
    for (int i = 0; i < 2; ++i) {
      const Real mass = random.over_decades(Real(0.1), 1000);
      world.add(random.moving_body(mass));
    }
    contact.id = {0, 1, 0};
    contact.point = random.vector(2);
    contact.normal = random.direction();
    contact.depth = random.between(0, Real(0.1));
  }
  Body& a() { return world.bodies[0]; }
  Body& b() { return world.bodies[1]; }
  /// Its row along a direction.
  Row row(const Vec3& direction) { return {world, contact, direction, 0}; }
};

}  // namespace pushback
