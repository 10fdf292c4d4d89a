/// Convex bodies, thrown at a plane, at a block or at each other.
#pragma once

#include "pushback/common/bodies/random.h"
#include "pushback/common/world/measure.h"
#include "pushback/common/world/step_solver.h"

namespace pushback {

struct Thrown {
  World world;
  Real dt;
  bool elastic;  // e = 1 and no friction: energy is to stay
};

/// A capsule, plank, bar, box or hull of any size between a third and three times that of a hand.
inline Body thrown_body(Random& random) {
  const Real size = random.over_decades(Real(0.1), 1);
  const Real mass = random.over_decades(1, 20);
  switch (random.below(5)) {
    case 0:
      return capsule(size / 4, 2 * size, mass);
    case 1:
      return box({size, size / 16, size / 2}, mass);
    case 2:
      return box({size / 10, 2 * size, size / 10}, mass);
    case 3:
      return box({size, Real(0.8) * size, size / 2}, mass);
    default:
      break;
  }
  std::vector<Vec3> points;
  for (int i = 0; i < 8; ++i) points.push_back(size * random.direction());
  return hull(points, mass);
}

inline Thrown thrown(std::uint64_t seed) {
  Random random(seed);
  Thrown made;
  World& world = made.world;
  const Real restitution = std::array{Real(0), Real(0.5), Real(1)}[random.below(3)];
  const Real friction = std::array{Real(0), Real(0.5)}[random.below(2)];
  made.dt = Real(1) / static_cast<Real>(std::array{60, 120}[random.below(2)]);
  made.elastic = restitution == 1 && friction == 0;
  const auto target = random.below(3);
  if (random.below(2) == 0 || target == 2) world.gravity.setZero();
  const auto add = [&](const Vec3& place, const Vec3& velocity) {
    const Body body = thrown_body(random).oriented(random.orientation()).at(place).moving(velocity);
    world.add(Body(body).spinning(random.vector(random.below(2) == 0 ? 4 : 12)).bouncy(restitution).rough(friction));
  };
  if (target == 0) world.add(ground().rough(friction));
  if (target == 1) world.add(box({10, 1, 10}, 1).fixed().at({0, -1, 0}).rough(friction));
  const auto towards = [&random](const Vec3& direction, Real fastest, Real aside) -> Vec3 {
    const Vec3 ahead = random.between(1, fastest) * direction;  // apart, because operands have no order
    return ahead + random.vector(aside);
  };
  if (target < 2) {
    add({0, Real(2.5), 0}, towards(-Vec3::UnitY(), 6, 1));
  } else {
    add({-Real(2.5), 0, 0}, towards(Vec3::UnitX(), 4, Real(0.3)));
    add({Real(2.5), 0, 0}, towards(-Vec3::UnitX(), 3, Real(0.3)));
  }
  return made;
}

struct AfterThrow {
  Real deepest = 0;  // m, at the end of any step
  Real energy = 0;   // |E - E0| in parts of the kinetic energy at first, the largest
};

inline AfterThrow play(Thrown made, StepSolver& solver, Real seconds) {
  World& world = made.world;
  const auto energy = [&world] { return kinetic_energy(world) + potential_energy(world); };
  const Real first = energy(), unit = kinetic_energy(world);
  AfterThrow after;
  for (int steps = static_cast<int>(std::lround(seconds / made.dt)); steps > 0; --steps) {
    world.step(solver, made.dt);
    World now = world;
    now.find_contacts();
    after.deepest = std::max(after.deepest, deepest_overlap(now));
    after.energy = std::max(after.energy, std::abs(energy() - first) / unit);
  }
  return after;
}

}  // namespace pushback
