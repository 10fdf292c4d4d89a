/// Augmented vertex block descent.
#include "pushback/chapters/07_warm_start/full_solver.h"
#include "pushback/chapters/08_friction_cone/friction_cone.h"
#include "pushback/common/world/measure.h"
#include "tests/methods/played.h"
#include "tests/support/catch.h"
#include "tests/support/on_ground.h"

using namespace pushback;

using Cone = Solver<Clamping, Baumgarte, Slop, Restitution, FrictionCone, WarmStart>;

TEST_CASE("avbd: 0.95 of an old overlap is left in each step") {
  World world;
  const Body& ball = ball_on_ground(world, Real(0.02));
  Avbd solver;
  Real depth = Real(0.02);
  for (int i = 0; i < 20; ++i) {
    world.step(solver, h, 60);
    depth *= solver.error_kept;
    CHECK(depth_of(ball) == Approx(depth).epsilon(in_double ? 1e-6 : 1e-2));
  }
}

TEST_CASE("avbd: a heavy box on a light one, where sequential impulses sink or fall") {
  CHECK(error_of<Cone>("heavy-on-light", 1, 16) > 0.5);
  CHECK(error_of<Avbd>("heavy-on-light", 1, 16) < 0.01);
  CHECK(error_of<Avbd>("heavy-on-light", 16, 1) < 0.005);
}

// A body feels f of the V that the other one had: what it does to the other is another f, until nothing changes any more.
TEST_CASE("avbd: momentum is conserved as far as sweeps have converged, and no farther") {
  const auto lost = [](int sweeps) {
    World world;
    world.gravity.setZero();
    world.add(sphere(Real(0.5), 5).at({0, 0, 0}));
    world.add(sphere(Real(0.5), 2).at({Real(0.1), Real(1.05), 0}).moving({0, -3, 0}));
    const Vec3 before = momentum(world);
    Avbd solver;
    for (int i = 0; i < 30; ++i) world.step(solver, h, sweeps);
    return (momentum(world) - before).norm() / before.norm();
  };
  CHECK(lost(1) == Approx(0.79).margin(0.01));  // docs/methods.md says so
  CHECK(lost(10) == Approx(0.003).margin(0.0005));
  CHECK(lost(60) < (in_double ? Real(1e-8) : Real(1e-5)));
}
