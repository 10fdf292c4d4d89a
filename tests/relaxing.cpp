/// The relaxing pass of soft contacts: what it takes back, and what it leaves alone.
#include "tests/soft_contacts.h"

using namespace pushback;

// ---- the relaxing pass -----------------------------------------------------------------------------------------------

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
  Solver<Clamping, SoftContacts, WarmStart> solver;
  Real taken = 0;
  for (int step = 0; step < 2000; ++step) {
    const Real dt = h / 8;
    world.apply_forces(dt);
    world.find_contacts();
    solver.solve(world.contacts, dt, 1);
    world.move(dt);
    const Real before = kinetic_energy(world);
    solver.relax(world.contacts);
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
    Solver<Clamping, SoftWithoutRelaxing, WarmStart> without;
    SoftSolver with;
    without.fastest_push_out = with.fastest_push_out = fastest;
    for (int step = 0; step < 60; ++step) {
      const Real before = slow.position.y();
      small_steps(kept, without, h, 32);
      small_steps(taken, with, h, 32);
      REQUIRE((slow.position.y() - before) <= h * fastest + 32 * eps * (std::abs(before) + 1));
      REQUIRE(std::abs(slow.velocity.y()) <= 16 * eps * fastest);
    }
    CHECK(fast.velocity.y() == Approx(fastest).epsilon(is_double ? 1e-12 : 1e-4));
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

// Beyond the depth where the cap binds, the contact is rigid and rises at the fastest push-out. Before it, the spring lets
// through gamma / (K + gamma) of what the load adds to the speed in a step: so much further it may go, once.
TEST_CASE("what a great load presses deep into the ground comes up no faster than the push-out, and sinks no further") {
  const Real dt = h / 32;
  for (const Real load : {Real(1e3), Real(1e4), Real(1e5), Real(1e6), Real(1e9)}) {  // kg, on a ball of 10 kg
    World world;
    Body& ball = ball_on_ground(world, Real(0.05));
    world.forces.push_back({[load](World& pressed) { pressed.bodies[1].force.y() -= load * g; }});
    SoftSolver solver;
    const Real w = solver.angular_frequency(dt), stiff = dt * w * (2 * solver.damping_ratio + dt * w);  // K / gamma
    const Real capped_from = solver.fastest_push_out * (2 * solver.damping_ratio + dt * w) / w;
    const Real fall = (1 + load / 10) * g * dt;  // m/s, added in a step
    const Real deepest = std::max(Real(0.05), capped_from + fall * dt / (1 + stiff)) + 64 * eps * (1 + fall * dt);
    for (int step = 0; step < 32 * 120; ++step) {
      const Real before = ball.position.y();
      world.step(solver, dt, 1);
      const Real depth = Real(0.3) - ball.position.y();
      INFO(load << " kg, step " << step << ": " << 1000 * depth << " mm deep");
      REQUIRE(ball.position.y() - before <= solver.fastest_push_out * dt + 64 * eps * (1 + fall * dt));
      REQUIRE(depth <= deepest);
    }
  }
}
