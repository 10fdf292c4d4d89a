/// How an overlap goes when it is fed back.
#include "pushback/chapters/03_baumgarte/baumgarte.h"
#include "pushback/common/world/measure.h"
#include "tests/support/catch.h"
#include "tests/support/on_ground.h"

using namespace pushback;

TEST_CASE("03: a bilateral row: d_k = d_0 (1 - beta)^k") {
  const Real d0 = Real(0.06);
  for (const Real beta : {Real(0.05), Real(0.1), Real(0.2), Real(0.5), Real(0.9)}) {
    for (const bool with_gravity : {false, true}) {
      World ball, four;
      ball_on_ground(ball, d0);
      box_on_ground(four, d0);
      if (!with_gravity) ball.gravity = four.gravity = Vec3::Zero();
      Solver<Baumgarte> one, several;
      one.beta = several.beta = beta;
      Real d = d0;
      for (int k = 1; k <= 20; ++k) {
        ball.step(one, h, one_sweep);
        four.step(several, h, enough_sweeps);
        d *= 1 - beta;
        // The depth is a difference of heights of about 1 m: it has their rounding.
        REQUIRE(std::abs(depth_of(ball.bodies[1]) - d) <= tiny * d + 64 * eps);
        REQUIRE(std::abs(Real(0.5) - four.bodies[1].position.y() - d) <= tiny * d + 256 * eps);
      }
    }
  }
}

TEST_CASE("03: a contact without gravity leaves at beta d_0 / h, and d_k = d_0 (1 - k beta)") {
  const Real d0 = Real(0.06);
  for (const Real beta : {Real(0.1), Real(0.2), Real(0.5), Real(1)}) {
    World world;
    Body& ball = ball_on_ground(world, d0);
    world.gravity.setZero();
    Solver<Clamping, Baumgarte> solver;
    solver.beta = beta;
    for (int k = 1; k <= 20; ++k) {
      world.step(solver, h, one_sweep);
      REQUIRE(ball.velocity.y() == Approx(beta * d0 / h).epsilon(64 * eps));
      REQUIRE(std::abs(depth_of(world.bodies[1]) - d0 * (1 - static_cast<Real>(k) * beta)) <= 64 * eps);
    }
    const Real fed_in = 10 * std::pow(beta * d0 / h, Real(2)) / 2;  // J: the speed is the energy
    CHECK(kinetic_energy(world) == Approx(fed_in).epsilon(128 * eps));
  }
}

TEST_CASE("03: under gravity a contact follows d_0 (1 - beta)^k as long as d <= g h^2 / beta^2, and no longer") {
  for (const Real beta : {Real(0.2), Real(0.5), Real(1)}) {
    const Real limit = g * h * h / (beta * beta);  // 68 mm and 2.7 mm
    if (beta == Real(0.2)) CHECK(limit == Approx(0.068).epsilon(0.01));
    if (beta == Real(1)) CHECK(limit == Approx(0.0027).epsilon(0.02));
    for (const Real part : {Real(0.5), Real(0.99), Real(1.01), Real(2)}) {
      const Real d0 = part * limit;
      World world;
      ball_on_ground(world, d0);
      Solver<Clamping, Baumgarte> solver;
      solver.beta = beta;
      world.step(solver, h, one_sweep);
      REQUIRE(std::abs(depth_of(world.bodies[1]) - d0 * (1 - beta)) <= tiny * d0);
      // In the second step gravity takes g h off the speed; if more than that is too much, the contact lets go.
      world.step(solver, h, one_sweep);
      const Real exponential = d0 * (1 - beta) * (1 - beta);
      const Real overshoot = std::max(Real(0), beta * beta * d0 - g * h * h);
      INFO("beta " << beta << ", " << part << " of the limit");
      CHECK(std::abs(depth_of(world.bodies[1]) - (exponential - overshoot)) <= tiny * d0 + 64 * eps);
      if (part > 1) {
        CHECK(world.contacts.at(0).impulse.isZero(0));
        continue;
      }
      for (int k = 3; k <= 20; ++k) {
        world.step(solver, h, one_sweep);
        REQUIRE(std::abs(depth_of(world.bodies[1]) - d0 * std::pow(1 - beta, static_cast<Real>(k))) <=
                tiny * d0 + 64 * eps);
      }
    }
  }
}
