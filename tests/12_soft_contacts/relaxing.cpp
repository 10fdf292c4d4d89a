/// The relaxing pass of soft contacts: what it takes back, and what it leaves alone.
#include "pushback/chapters/12_soft_contacts/steady_solver.h"
#include "tests/12_soft_contacts/soft_contacts.h"
#include "tests/support/substeps.h"

using namespace pushback;

// Balls: their inertia is the same however they have turned since the rows were made.
TEST_CASE("relaxing takes energy or leaves it, in every step of a heap without friction") {
  Random random(3);
  World world;
  world.add(ground());
  for (int i = 0; i < 20; ++i) {
    const Real mass = random.over_decades(1, 100), size = random.between(Real(0.1), Real(0.5));
    Vec3 place = random.vector(Real(0.5));
    place.y() += 1;
    world.add(sphere(size, mass).at(place));
  }
  RelaxingSolver<Clamping, SoftContacts, WarmStart> solver;
  Real taken = 0;
  for (int step = 0; step < 2000; ++step) {
    const Real dt = h / 8;
    world.begin_step(dt);
    solver.solve(world, dt, 1);
    world.move(dt);
    const Real before = kinetic_energy(world);
    solver.after_move(world, dt);
    REQUIRE(kinetic_energy(world) <= before * (1 + 64 * eps));
    taken += before - kinetic_energy(world);
  }
  CHECK(taken > 1);  // J
}

TEST_CASE("what is born deep inside is pushed out at the fastest push-out, and keeps nothing of it") {
  for (const Real fastest : {Real(0.5), Real(3)}) {
    World kept, taken;
    kept.gravity.setZero();
    taken.gravity.setZero();
    Body &fast = ball_on_ground(kept, Real(0.1)), &slow = ball_on_ground(taken, Real(0.1));
    Unrelaxed<Clamping, SoftContacts, WarmStart> without;
    SoftSolver with;
    without.fastest_push_out = with.fastest_push_out = fastest;
    for (int step = 0; step < 60; ++step) {
      const Real before = slow.position.y();
      substeps(kept, without, h, 32);
      substeps(taken, with, h, 32);
      REQUIRE((slow.position.y() - before) <= h * fastest + 32 * eps * (std::abs(before) + 1));
      REQUIRE(std::abs(slow.velocity.y()) <= 16 * eps * fastest);
    }
    CHECK(fast.velocity.y() == Approx(fastest).epsilon(in_double ? 1e-12 : 1e-4));
    CHECK(std::abs(deepest_overlap(taken)) < Real(1e-6));
  }
}

TEST_CASE("a bounce is not relaxed away") {
  for (const Real e : {Real(0.5), Real(1)}) {
    World world;
    Body& ball = ball_on_ground(world, Real(-0.5)).bouncy(e);
    SoftSolver solver;
    for (int step = 0; step < 4000 && ball.velocity.y() <= 0; ++step) world.step(solver, h / 32, 1);
    CHECK(ball.velocity.y() == Approx(-e * ball.velocity_before.y()).epsilon(64 * eps));
  }
}

TEST_CASE(
    "a free pair keeps its momentum and its angular momentum to rounding, however it turns while it is pushed out") {
  Random random(4);
  for (int i = 0; i < 100; ++i) {
    World world;
    overlapping_pair(world, random);
    const Vec3 p = momentum(world), l = angular_momentum(world);
    Real mass = 0;
    for (const Body& body : world.bodies) mass += 1 / body.inverse_mass;
    SoftSolver solver;
    solver.hertz = 60;
    for (int step = 0; step < 32; ++step) {
      world.step(solver, h / 32, 1);
      REQUIRE((momentum(world) - p).norm() <= 1000 * eps * 3 * mass);
      REQUIRE((angular_momentum(world) - l).norm() <= 1000 * eps * 3 * mass);  // the arms are about 1 m
    }
  }
}

namespace {

/// A ball of 0.5 m and 100 kg that slides at 6 m/s until it rolls: over the ground, or over a plank on smooth ground.
struct Roller {
  World world;
  std::size_t below = 0;

  explicit Roller(Real plank) {
    world.add(ground().rough(plank > 0 ? 0 : Real(0.3)));
    if (plank > 0) below = static_cast<std::size_t>(world.add(box({20, Real(0.1), 2}, plank).at({10, Real(0.1), 0})));
    world.add(sphere(Real(0.5), 100).at({0, plank > 0 ? Real(0.7) : Real(0.5), 0}).moving({6, 0, 0}).rough(Real(0.3)));
  }
  Real speed() const { return world.bodies.back().velocity.x() - world.bodies[below].velocity.x(); }
  template <class ContactSolver>
  void roll(ContactSolver& solver, Real seconds, int steps) {
    for (int step = 0; step < static_cast<int>(seconds * 60); ++step) substeps(world, solver, h, steps);
  }
};
/// The part of its speed that it gains from the first second to the third.

}  // namespace

// m v + I w / r stays while it slides, about the line of contact: 5/7 of the speed is left when it rolls.
TEMPLATE_TEST_CASE("a ball that rolls over the ground keeps its speed, in steps of any size", "", SoftSolver,
                   SteadySolver) {
  for (const int steps : {1, 4, 16}) {
    Roller ball(0);
    TestType solver;
    ball.roll(solver, 3, steps);
    INFO(steps << " substeps");
    CHECK(std::abs(ball.speed() / (Real(6) * 5 / 7) - 1) <= 1000 * eps);
  }
}
