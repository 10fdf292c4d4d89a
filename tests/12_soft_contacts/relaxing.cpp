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
template <class ContactSolver>
Real gained_over(Real plank, int steps) {
  Roller ball(plank);
  ContactSolver solver;
  ball.roll(solver, 1, steps);
  const Real rolling = ball.speed();
  ball.roll(solver, 2, steps);
  return ball.speed() / rolling - 1;
}

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

// A light plank is pressed, and tilts, as the ball comes and goes, relaxed or not.
TEMPLATE_TEST_CASE("a ball that rolls over a plank is not braked by relaxing", "", SoftSolver, SteadySolver) {
  using NotRelaxed = Unrelaxed<Clamping, SoftContacts, Restitution, Friction, WarmStart>;
  for (const Real plank : {Real(1e5), Real(100), Real(10)}) {  // kg
    const Real gained = gained_over<TestType>(plank, 16), not_relaxed = gained_over<NotRelaxed>(plank, 16);
    INFO("a plank of " << plank << " kg: " << gained << ", not relaxed " << not_relaxed);
    CHECK(std::abs(gained - not_relaxed) <= Real(in_double ? 1e-6 : 1e-4));
    if (plank >= 1000) CHECK(std::abs(gained) <= Real(in_double ? 1e-8 : 1e-4));
  }
}

// Of m = (change of x_B - x_A) x n each arm takes a part: J V changes by -s m . w_A - (1 - s) m . w_B, which s can make
// zero where the two have not the same sign.
TEST_CASE("relaxing places a row at one point for both bodies, and there it reads the speed that it read before") {
  Random random(9);
  for (int i = 0; i < 1000; ++i) {
    World world;
    for (const bool second : {false, true}) {
      Body body = random.moving_body(random.over_decades(1, 100));
      if (!second && i % 3 == 0) body.fixed();
      world.add(body);
    }
    Body &a = world.bodies[0], &b = world.bodies[1];
    Contact contact;
    contact.id = {0, 1, 0};
    contact.point = random.vector(2);
    world.contacts = {contact};
    Rows rows = {{world, contact, random.direction(), 0}, {world, contact, random.direction(), 0}};
    std::vector<Real> softness(1, 0);
    RelaxingContext step{{world, world.contacts, rows, h}, softness};
    SoftContacts soft;
    soft.build(step);
    soft.start(step);
    const Vec3 apart = b.position - a.position;
    const Real before[] = {rows[0].speed(), rows[1].speed()};
    for (Body& body : world.bodies) body.position += h * body.velocity;
    soft.relax(step);
    for (std::size_t k = 0; k < rows.size(); ++k) {
      const Row& row = rows[k];
      const Vec3 m = (b.position - a.position - apart).cross(row.n);
      const Real of_a = m.dot(a.angular_velocity), of_b = m.dot(b.angular_velocity);
      const Real unavoidable = of_a * of_b > 0 ? 2 * std::min(std::abs(of_a), std::abs(of_b)) : 0;
      REQUIRE((row.ra_n - row.rb_n - (b.position - a.position).cross(row.n)).norm() <= 64 * eps);
      REQUIRE(std::abs(row.speed() - before[k]) <= unavoidable + 256 * eps);
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
