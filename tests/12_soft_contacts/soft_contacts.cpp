/// Soft contacts: the spring that they are. What the relaxing pass leaves is in relaxing.cpp.
#include "tests/12_soft_contacts/soft_contacts.h"
#include "tests/support/substeps.h"

using namespace pushback;

namespace {

/// A row somewhere between two bodies that overlap, in any direction.
Row any_row(World& world, Random& random) {
  overlapping_pair(world, random);
  Contact contact;
  contact.id = {0, 1, 0};
  contact.point = random.vector(1);
  contact.normal = random.direction();
  return {world, contact, contact.normal, 0};
}

}  // namespace

TEST_CASE("a soft normal ends at J V + b + gamma lambda = 0, wherever it starts") {
  Random random(1);
  for (int i = 0; i < 500; ++i) {
    World world;
    Rows rows{any_row(world, random)};
    Row& row = rows[0];
    const Real K = 1 / row.effective_mass;
    std::vector<Real> softness{K * random.over_decades(Real(0.01), 100)};
    RelaxingContext step{{world, world.contacts, rows, h}, softness};
    row.bias = random.between(-3, 3);
    row.effective_mass = 1 / (K + softness[0]);
    row.reach(random.between(-10, 10));
    step.solve(0);
    const Real size = std::abs(row.speed()) + std::abs(row.bias) + (K + softness[0]) * (std::abs(row.impulse) + 10);
    REQUIRE(std::abs(row.speed() + row.bias + softness[0] * row.impulse) <= 32 * eps * size);
    REQUIRE(std::abs(step.speed_error(0)) <= 32 * eps * size);
  }
}

TEST_CASE("a row without softness gets, to the bit, what a step without any gives it") {
  Random random(2);
  for (int i = 0; i < 500; ++i) {
    World world;
    Rows rows{any_row(world, random)};
    rows[0].bias = random.between(-3, 3);
    rows[0].reach(random.between(-10, 10));
    const Real wanted = rows[0].wanted();
    std::vector<Real> softness{0};
    RelaxingContext step{{world, world.contacts, rows, h}, softness};
    REQUIRE(step.speed_error(0) == step.StepContext::speed_error(0));
    step.solve(0);
    REQUIRE(rows[0].impulse == wanted);
  }
}

TEST_CASE("a ball on a soft contact that may also pull moves as a damped spring under implicit Euler, step by step") {
  for (const Real zeta : {Real(0), Real(0.1), Real(1), Real(5)}) {
    for (const Real hertz : {Real(2), Real(10), Real(1000)}) {  // the last one is capped
      const Real dt = h / 4, m = 10;
      const Real w = 2 * pi * std::min(hertz, 1 / (8 * dt));
      const Real k = m * w * w, c = 2 * zeta * m * w, rest = m * g / k;
      World world;
      const Real start = rest * Real(1.5);
      Body& ball = ball_on_ground(world, start, m);
      Unrelaxed<SoftContacts> solver;
      solver.hertz = hertz;
      solver.damping_ratio = zeta;
      solver.fastest_push_out = 1000;
      // v' = v + h (-g - (k C' + c v') / m),  C' = C + h v':  solved for v'.
      Real C = -start, v = 0;
      for (int step = 0; step < 2000; ++step) {
        world.step(solver, dt, 1);
        v = (v - dt * g - dt * k * C / m) / (1 + dt * c / m + dt * dt * k / m);
        C += dt * v;
        REQUIRE(C < 0);  // it never leaves the ground
        REQUIRE(std::abs(ball.position.y() - Real(0.3) - C) <= (in_double ? Real(1e-12) : Real(1e-4)));
        REQUIRE(std::abs(ball.velocity.y() - v) <= (in_double ? Real(1e-11) : Real(1e-3)));
      }
    }
  }
}

TEST_CASE("a body rests where the spring carries it: g / w^2 deep, a cube on its four corners too") {
  for (const int count : {4, 32}) {
    for (const Real hertz : {Real(30), Real(1e6)}) {
      const Real dt = h / static_cast<Real>(count);
      World ball, cube;
      ball_on_ground(ball, Real(0.001));
      stack(cube, 1);
      SoftSolver under_ball, under_cube;
      under_ball.hertz = under_cube.hertz = hertz;
      for (int step = 0; step < 300; ++step) {
        substeps(ball, under_ball, h, count);
        substeps(cube, under_cube, h, count);
      }
      const Real w = 2 * pi * std::min(hertz, 1 / (8 * dt));
      INFO(count << " substeps, " << hertz << " hertz: " << deepest_overlap(ball) << " m and " << deepest_overlap(cube)
                 << " m, should be " << g / (w * w) << " m");
      CHECK(deepest_overlap(ball) == Approx(g / (w * w)).epsilon(in_double ? 1e-6 : 0.05));
      CHECK(deepest_overlap(cube) == Approx(g / (w * w)).epsilon(in_double ? 1e-6 : 0.05));
    }
  }
}

TEST_CASE("a box that carries another M / m times as heavy rests (1 + M/m) g / w^2 deep, in the ground and under it") {
  const Real w = 2 * pi * 240;
  for (const Real heavier : {Real(1), Real(10), Real(100)}) {
    World world;
    world.add(ground());
    world.add(box(Vec3::Constant(Real(0.5)), 100).at({0, Real(0.5), 0}));
    world.add(box(Vec3::Constant(Real(0.5)), 100 * heavier).at({0, Real(1.5), 0}));
    SoftSolver solver;
    for (int step = 0; step < 600; ++step) substeps(world, solver, h, 32);
    const Real depth = (1 + heavier) * g / (w * w);
    INFO("1 : " << heavier << ": " << deepest_overlap(world) << " m, should be " << depth << " m");
    REQUIRE(world.contacts.size() == 8);
    for (const Contact& contact : world.contacts)
      CHECK(contact.depth == Approx(depth).epsilon(in_double ? 1e-4 : 0.05));
  }
}

TEST_CASE("stable however stiff, whatever the step") {
  for (const Real hertz : {Real(1), Real(60), Real(1e4), Real(1e9)}) {
    for (const Real zeta : {Real(0), Real(1), Real(10), Real(1e6)}) {
      for (const Real dt : {Real(1e-5), h / 32, h, Real(0.1)}) {
        World world;
        ball_on_ground(world, Real(0.002));
        world.add(box({Real(0.4), Real(0.1), Real(0.4)}, 50).at({2, Real(0.099), 0}));
        SoftSolver solver;
        solver.hertz = hertz;
        solver.damping_ratio = zeta;
        const Real start = kinetic_energy(world) + potential_energy(world);
        // Fed in at most: the speed of the push-out. Deep at most: twice the depth at rest, as an undamped spring swings.
        const Real w = solver.angular_frequency(dt), fed = 60 * solver.fastest_push_out * solver.fastest_push_out / 2;
        const Real deep = Real(0.002) + 2 * g / (w * w) + 2 * g * dt * dt;
        for (int step = 0; step < 600; ++step) {
          world.step(solver, dt, 1);
          const Real now = kinetic_energy(world) + potential_energy(world);
          const Real ball_depth = Real(0.3) - world.bodies[1].position.y();
          INFO(hertz << " hertz, zeta " << zeta << ", dt " << dt << ", step " << step << ": " << now - start << " J, "
                     << ball_depth << " m");
          REQUIRE(std::isfinite(now));
          REQUIRE(now - start < fed);
          REQUIRE(ball_depth < deep);
        }
      }
    }
  }
}

TEST_CASE("a spring that cannot be is refused by name") {
  const auto stepped = [](const std::function<void(SoftSolver&)>& change) {
    World world;
    ball_on_ground(world, Real(0.01));
    SoftSolver solver;
    change(solver);
    world.step(solver, h, 1);
  };
  const Real nan = std::numeric_limits<Real>::quiet_NaN(), infinite = std::numeric_limits<Real>::infinity();
  for (const Real wrong : {Real(0), Real(-1), nan, infinite})
    CHECK_THROWS_AS(stepped([&](SoftSolver& solver) { solver.hertz = wrong; }), InvalidInput);
  for (const Real wrong : {Real(-1), nan, infinite}) {
    CHECK_THROWS_AS(stepped([&](SoftSolver& solver) { solver.damping_ratio = wrong; }), InvalidInput);
    CHECK_THROWS_AS(stepped([&](SoftSolver& solver) { solver.fastest_push_out = wrong; }), InvalidInput);
  }
  CHECK_NOTHROW(stepped([](SoftSolver& solver) { solver.damping_ratio = solver.fastest_push_out = 0; }));
}
