/// A row without limits: J V = 0, in both directions.
#include "pushback/chapters/01_velocity_constraint/scenes.h"
#include "pushback/chapters/01_velocity_constraint/solver.h"
#include "tests/support/catch.h"
#include "tests/support/on_ground.h"

using namespace pushback;

TEST_CASE("01: after the solve J V = 0, and the overlap stays as it was") {
  World world;
  Body& ball = ball_on_ground(world, Real(0.02)).moving({0, -3, 0});
  Solver<> solver;
  for (int step = 0; step < 600; ++step) {
    world.step(solver, h, one_sweep);
    REQUIRE(largest_error(solver) <= 16 * eps * 3);
    REQUIRE(std::abs(ball.velocity.y()) <= 16 * eps * 3);
  }
  CHECK(std::abs(depth_of(world.bodies[1]) - Real(0.02)) <= 600 * eps);
}

TEST_CASE(
    "01: what one sweep leaves depends on where the points are: at the edge of the slab, or at the box's corners") {
  const auto left_by_one_sweep = [](Real half_depth) {
    World world;
    world.add(box({4, Real(0.25), half_depth}, 1).fixed().at({0, Real(-0.25), 0}));
    world.add(box(Vec3::Constant(Real(0.5)), 100).at({0, Real(1.54), 0}));
    Solver<> solver;
    Real most = 0;
    for (int step = 0; step < 60; ++step) {
      world.step(solver, h, one_sweep);
      most = std::max(most, largest_error(solver));
    }
    return most;
  };
  CHECK(left_by_one_sweep(Real(0.47)) == Approx(1.03).margin(0.005));  // m/s
  CHECK(left_by_one_sweep(Real(0.6)) == Approx(1.44).margin(0.005));
}

TEST_CASE("01: a box let go under a plate hangs there, pulled by as much as gravity takes") {
  World world;
  velocity_constraint_scenes::DroppedAndUnderPlate{}(world);
  const std::size_t hung = world.bodies.size() - 1;
  const Real height = world.bodies[hung].position.y();
  Solver<> solver;
  for (int step = 0; step < 120; ++step) world.step(solver, h, 10);
  CHECK(std::abs(world.bodies[hung].position.y() - height) < Real(1e-6));
  Real upwards = 0;
  for (const Contact& contact : world.contacts)
    if (contact.id.body_a == hung || contact.id.body_b == hung) upwards += std::abs(contact.impulse.y());
  CHECK(upwards == Approx(100 * g * h).epsilon(1e-6));
}
