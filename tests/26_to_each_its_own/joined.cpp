/// Chapter 26: bodies that are joined and meet something, by half steps.
#include "pushback/chapters/13_joints/hinge.h"
#include "pushback/chapters/24_half_step/on_floor.h"
#include "pushback/chapters/25_moment_of_impact/scenes.h"
#include "pushback/common/bodies/random.h"
#include "pushback/common/world/measure.h"
#include "pushback/engine/islands/island_solver.h"
#include "tests/24_half_step/order.h"
#include "tests/support/catch.h"
#include "tests/support/yardstick.h"

using namespace pushback;

namespace {

/// What falls, swings or is thrown, in a few bodies that are joined, and what it may meet. All of it drawn.
using Drawn = void (*)(World&, Random&);
void chain_over_floor(World& world, Random& random) {
  const Real mu = random.between(0, 1), e = random.below(2) == 0 ? 0 : random.between(0, Real(0.8));
  world.add(ground().rough(mu).bouncy(e));
  Vec3 end(0, random.between(Real(0.6), 2), 0);
  int before = the_world;
  for (int left = 2 + static_cast<int>(random.below(4)); left > 0; --left) {
    Vec3 along = random.direction();
    along.y() = Real(0.4) * std::abs(along.y());
    along.normalize();
    const Real length = random.between(Real(0.3), Real(0.6)), mass = random.over_decades(Real(0.3), 10);
    const Body link = random.below(2) == 0 ? box({Real(0.06), Real(0.4) * length, Real(0.06)}, mass)
                                           : capsule(Real(0.06), Real(0.3) * length, mass);
    const int body = world.add(Body(link)
                                   .oriented(Quat::FromTwoVectors(Vec3::UnitY(), along))
                                   .at(end + length / 2 * along)
                                   .rough(mu)
                                   .bouncy(e));
    if (before != the_world) {
      const Vec3 axis = random.direction();
      world.joints.push_back(random.below(3) == 0 ? hinge(world, before, body, end, axis)
                                                  : ball_and_socket(world, before, body, end));
    }
    before = body;
    end += length * along;
  }
}
void pendulum_beside_wall(World& world, Random& random) {
  const Real mu = random.below(2) == 0 ? 0 : random.between(0, 1), e = random.between(0, 1);
  world.add(half_space(-Vec3::UnitX()).at({random.between(Real(0.1), Real(0.7)), 0, 0}).rough(mu).bouncy(e));
  Vec3 end = Vec3::Zero();
  int before = the_world;
  Real angle = random.between(Real(-1.5), Real(-0.3));
  for (int left = 1 + static_cast<int>(random.below(3)); left > 0; --left) {
    const Real length = random.between(Real(0.3), Real(0.8)), mass = random.over_decades(Real(0.5), 10);
    const Vec3 along(std::sin(angle), -std::cos(angle), 0);
    const int body = world.add(box({Real(0.03), length / 2, Real(0.03)}, mass)
                                   .turned(angle, Vec3::UnitZ())
                                   .at(end + length / 2 * along)
                                   .rough(mu)
                                   .bouncy(e));
    world.joints.push_back(ball_and_socket(world, before, body, end));
    before = body;
    end += length * along;
    angle += random.between(Real(-0.3), Real(0.1));
  }
}
void door_and_stop(World& world, Random& random) {
  const Real mu = random.between(0, 1), e = random.between(0, Real(0.9)), width = random.between(Real(0.6), Real(1.2));
  world.add(box({width / 2, 1, Real(0.03)}, 20).at({width / 2, 0, 0}).rough(mu).bouncy(e));
  const Real z = random.between(Real(-0.2), Real(0.2)), x = random.between(Real(-0.2), Real(0.2));
  const Vec3 axis = Vec3(x, 1, z).normalized();
  world.joints.push_back(hinge(world, the_world, 0, Vec3::Zero(), axis));
  world.bodies[0].angular_velocity = random.between(1, 12) * axis;
  world.bodies[0].velocity = world.bodies[0].angular_velocity.cross(world.bodies[0].position);
  const Real angle = random.between(Real(0.4), Real(1.5)), reach = width * random.between(Real(0.5), Real(0.95));
  const Vec3 stop(reach * std::cos(angle), random.between(Real(-0.8), Real(0.8)), -reach * std::sin(angle));
  world.add(sphere(Real(0.06), 1).fixed().at(stop).rough(mu).bouncy(e));
}
}  // namespace

TEST_CASE("joined, by island: who is joined to what it overlaps does not meet it, however fast") {
  World world;
  world.gravity.setZero();
  world.add(box({Real(0.2), 1, Real(0.2)}, 1).fixed());
  world.add(box({Real(0.8), 1, Real(0.05)}, 10).at({Real(0.8), 0, 0}).spinning({0, 20, 0}).moving({0, 0, -16}));
  world.joints.push_back(hinge(world, 0, 1, Vec3::Zero(), Vec3::UnitY()));
  const Real motion = kinetic_energy(world);
  IslandSolver solver;
  for (int i = 0; i < 30; ++i) {
    world.step(solver, h);
    CHECK(world.contacts.empty());
    CHECK(solver.step_of(1) == StepType::half_steps);
  }
  CHECK(kinetic_energy(world) == Approx(motion).epsilon(in_double ? 1e-6 : 1e-3));
}

TEST_CASE("joined, by island: of scenes that nobody has looked at none gains energy by half steps, and joints hold") {
  if (!in_double) return;
  int by_half_steps = 0, by_substeps = 0;
  int family = 0;
  for (const Drawn& draw : {chain_over_floor, pendulum_beside_wall, door_and_stop}) {
    ++family;
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      CAPTURE(family, seed);
      Random random(seed + 2600);
      World world;
      draw(world, random);
      Real mass = 0;
      for (const Body& body : world.bodies) mass += body.movable() ? 1 / body.inverse_mass : 0;
      IslandSolver solver;
      bool before = true;
      for (int i = 0; i < 180; ++i) {
        const Real motion = kinetic_energy(world), begin = energy(world), overlap = deepest(world);
        world.step(solver, h);
        REQUIRE(std::isfinite(energy(world)));
        const bool now = std::none_of(world.bodies.begin(), world.bodies.end(), [&solver](const Body& body) {
          return solver.step_of(body.index) == StepType::substeps;
        });
        (now ? by_half_steps : by_substeps) += 1;
        if (now) {
          CAPTURE(i, solver.half_steps_of(1), overlap, world.contacts.size());
          const Real least = std::max(motion, kinetic_energy(world)) + mass * (h * world.gravity).squaredNorm() / 2;
          // What overlaps comes out: no farther than it was in, at each of a few contacts.
          CHECK(energy(world) - begin <= solver.energy * least + 12 * mass * g * overlap + 1e-12);
          CHECK(residuals(world).position <= 1e-9);
        }
        if (now && before) CHECK(deepest(world) <= std::max(overlap, Real(0.003)));
        before = now;
      }
    }
  }
  INFO(by_half_steps << " steps by half steps, " << by_substeps << " by substeps");
  CHECK(by_half_steps > 3000);
}
