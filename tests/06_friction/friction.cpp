/// How far a box slides, when a ball rolls.
#include "pushback/chapters/06_friction/friction.h"
#include "pushback/tools/measure/hard_cases/sliding.h"
#include "tests/support/catch.h"
#include "tests/support/on_ground.h"

using namespace pushback;

namespace {

/// Without the warm start, so that every step is on its own.
using Rubbing = Solver<Clamping, Baumgarte, Slop, Restitution, Friction>;

/// How far it gets.
Real stopping_distance(Real mu, Real speed, Real dt) {
  World world;
  sliding_box(world, mu, speed, 0);
  Rubbing solver;
  const int steps = static_cast<int>(speed / (mu * g * dt)) + 20;
  for (int step = 0; step < steps; ++step) world.step(solver, dt, enough_sweeps);
  CHECK(world.bodies[1].velocity.norm() < tiny);
  return world.bodies[1].position.x();
}

}  // namespace

TEST_CASE("06: a sliding box stops where the discrete sum says, v0 h / 2 short of v0^2 / (2 mu g)") {
  for (const Real mu : {Real(0.2), Real(0.5), Real(0.8)}) {
    for (const Real speed : {Real(3), Real(10)}) {
      for (const Real dt : {h, h / 2, h / 4}) {
        const Real way = stopping_distance(mu, speed, dt), sum = discrete_distance(mu, speed, dt),
                   smooth = speed * speed / (2 * mu * g);
        INFO("mu " << mu << ", v0 " << speed << ", dt " << dt << ": " << way << " m, sum " << sum << " m, v0^2/2 mu g "
                   << smooth << ", rel. " << (way - sum) / sum);
        CHECK(way == Approx(sum).epsilon(tiny));
        CHECK(std::abs(smooth - way - speed * dt / 2) <
              mu * g * dt * dt + tiny * smooth);  // O(h^2), from the last, shorter step
      }
    }
  }
  // 0.8 % short at 10 m/s, mu = 0.5, 1/60 s.
  CHECK(1 - discrete_distance(Real(0.5), 10, h) / (100 / g) == Approx(0.008).epsilon(0.05));
}

TEST_CASE("06: a box slides down a slope only if tan(theta) > mu, with a = g (sin(theta) - mu cos(theta))") {
  for (const Real theta : {Real(0.2), Real(0.5), Real(0.8)}) {
    for (const Real part : {Real(0.1), Real(0.5), Real(0.9), Real(0.99), Real(1.01), Real(1.1), Real(2)}) {
      const Real mu = part * std::tan(theta);
      const Vec3 down{-std::cos(theta), -std::sin(theta), 0};
      World world;
      box_on_slope(world, theta, mu);
      Rubbing solver;
      constexpr int steps = 120;
      for (int step = 0; step < steps; ++step) world.step(solver, h, enough_sweeps);
      const Real slid = world.bodies[1].position.dot(down), speed = world.bodies[1].velocity.dot(down);
      if (part < 1) {
        const Real a = g * (std::sin(theta) - mu * std::cos(theta));
        INFO("theta " << theta << ", mu " << part << " tan: rel. " << speed / (a * steps * h) - 1);
        CHECK(speed == Approx(a * steps * h).epsilon(tiny));
        CHECK(slid == Approx(a * h * h * steps * (steps + 1) / 2).epsilon(tiny));
      } else {
        INFO("theta " << theta << ", mu " << part << " tan: creeps " << slid << " m");
        CHECK(std::abs(slid) < tiny);  // m, in two seconds
      }
    }
  }
}

TEST_CASE("06: a ball thrown without spin ends rolling at 5/7 of its speed") {
  for (const Real mu : {Real(0.1), Real(0.5)}) {
    for (const Real v0 : {Real(1), Real(5)}) {
      World world;
      const Real radius = Real(0.3), depth = Real(1e-6);
      Body& ball = ball_on_ground(world, depth).rough(mu).moving({v0, 0, 0});
      world.bodies[0].rough(mu);
      Rubbing solver;
      const int rolls_after = static_cast<int>(std::ceil(2 * v0 / (7 * mu * g * h)));  // steps
      for (int step = 1; step <= rolls_after + 60; ++step) {
        const Real before = ball.velocity.x();
        world.step(solver, h, one_sweep);
        if (step < rolls_after) REQUIRE(before - ball.velocity.x() == Approx(mu * g * h).epsilon(tiny));  // slides
        if (step > rolls_after) REQUIRE(std::abs(before - ball.velocity.x()) < tiny);                     // rolls
      }
      // Friction pulls at the contact point, midway between the surfaces: half the depth above the ball's lowest.
      const Real arm = radius - depth / 2;
      CHECK(ball.velocity.x() == Approx(v0 / (1 + Real(0.4) * radius * radius / (arm * arm))).epsilon(tiny));
      CHECK(ball.velocity.x() == Approx(v0 * 5 / 7).epsilon(depth / radius));
      CHECK(std::abs(ball.velocity.x() + ball.angular_velocity.z() * arm) < tiny);
    }
  }
}

TEST_CASE("06: the pyramid brakes by mu g along a tangent and by root 2 of that under 45 degrees") {
  for (const Real mu : {Real(0.2), Real(0.5)}) {
    for (const Real heading : {Real(0), pi / 8, pi / 4, 3 * pi / 8, pi / 2}) {
      World world;
      sliding_box(world, mu, 5, heading);
      Rubbing solver;
      const Vec3 before = world.bodies[1].velocity;
      world.step(solver, h, enough_sweeps);
      const Vec3 braked = (before - world.bodies[1].velocity) / h;
      const bool along_a_tangent = heading == 0 || heading == pi / 2;
      const Real should = along_a_tangent ? mu * g : std::sqrt(Real(2)) * mu * g;
      INFO("mu " << mu << ", heading " << heading << ": rel. " << braked.norm() / should - 1);
      CHECK(braked.norm() == Approx(should).epsilon(tiny));
      // And its direction is a corner of the pyramid, whatever the heading: the way bends.
      if (!along_a_tangent) CHECK(std::abs(braked.x()) == Approx(std::abs(braked.z())).epsilon(tiny));
    }
  }
}
