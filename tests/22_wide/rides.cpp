/// Contacts that ride with their bodies after detection, against detecting them again.
#include "pushback/chapters/21_detected_once/detected_once.h"
#include "pushback/chapters/21_detected_once/scenes.h"
#include "pushback/common/world/measure.h"
#include "pushback/common/world/situations.h"
#include "pushback/engine/substeps/wide_solver.h"
#include "tests/support/catch.h"
#include "tests/support/yardstick.h"

using namespace pushback;

TEST_CASE("rides: a cube that rolls on its edge, detected once in 32 substeps, goes as one that is detected in each") {
  for (const Real spin : {2, 3}) {
    const auto after = [spin](StepSolver& solver, int detections) {
      World world;
      detected_once_scenes::RollingCube cube;
      cube.spin = spin;
      cube(world);
      for (int i = 0; i < 6 * detections; ++i) world.step(solver, h / static_cast<Real>(detections));
      return world.bodies.back().position;
    };
    WideSolver<Real> exact, once;
    exact.rebuild_fraction = once.rebuild_fraction = 0;
    DetectedOnce carried;
    const Vec3 truth = after(exact, 32);
    const Real riding = (after(once, 1) - truth).norm(), not_riding = (after(carried, 1) - truth).norm();
    INFO("spin " << spin << ": " << 1000 * riding << " mm, carried " << 1000 * not_riding << " mm");
    CHECK(riding < (in_double ? Real(5e-6) : Real(5e-5)));
    CHECK(not_riding > Real(0.5e-3));
    WideSolver<Real> as_it_comes;
    const Real near = (after(as_it_comes, 1) - truth).norm();
    INFO("as it comes " << 1000 * near << " mm");
    CHECK(near < Real(0.01e-3) + (in_double ? 0 : Real(5e-5)));
  }
}

TEST_CASE(
    "floating: two boxes that meet slower than rows are otherwise placed keep their angular momentum to rounding") {
  World world;
  world.gravity.setZero();
  world.add(box({Real(0.5), Real(0.3), Real(0.2)}, 3).spinning({Real(0.01), 0, Real(0.02)}));
  world.add(box({Real(0.1), Real(0.4), Real(0.6)}, 1)
                .at({Real(0.602), Real(0.1), Real(0.3)})
                .moving({Real(-5e-4), 0, 0})
                .spinning({0, Real(0.01), Real(-0.03)}));
  const Vec3 before = angular_momentum(world);
  WideSolver<Real> solver;
  Real touched = 0;
  for (int i = 0; i < 600; ++i) {
    world.step(solver, h);
    for (const Contact& contact : world.contacts) touched += contact.impulse.norm();
  }
  REQUIRE(touched > Real(1e-4));
  const Real change = (angular_momentum(world) - before).norm();
  INFO("changed by " << change << " N m s of " << before.norm());
  CHECK(change < (in_double ? Real(1e-13) : Real(1e-6)));
}

TEST_CASE("wide: substeps are of 1/60 s, so that contacts are as stiff in a step of any length") {
  const WideSolver<Real> solver;
  CHECK(solver.plan(Real(1) / 60).substeps == 32);
  CHECK(solver.plan(Real(1) / 240).substeps == 8);
  CHECK(solver.plan(Real(1) / 30).substeps == 64);
  CHECK(solver.plan(Real(0.0101)).substeps == 20);
  CHECK(solver.plan(Real(1e-6)).substeps == 1);
  CHECK(solver.plan(std::numeric_limits<Real>::infinity()).substeps == 1000000);
  CHECK(solver.plan(std::numeric_limits<Real>::quiet_NaN()).substeps == 1000000);
  const auto depth_after = [](Real dt) {
    World world;
    stack(world, 3);
    WideSolver<Real> steps;
    while (world.time < 2) world.step(steps, dt);
    Real deepest = 0;
    for (const Contact& contact : world.contacts) deepest = std::max(deepest, contact.depth);
    return deepest;
  };
  const Real depth = depth_after(h);
  for (const Real dt : {Real(1) / 240, Real(0.0101), Real(1) / 30})
    CHECK(depth_after(dt) == Approx(depth).epsilon(in_double ? 1e-3 : 0.05));
}

TEST_CASE("wide: a box that a press lets go of does not jump") {
  World world;
  world.add(ground());
  world.add(box({Real(0.5), Real(0.5), Real(0.5)}, 100).at({0, Real(0.5), 0}));
  world.add(box({1, Real(0.1), 1}, 1).fixed().at({0, Real(1.1), 0}).moving({0, -Real(0.1), 0}));
  WideSolver<Real> solver;
  for (int i = 0; i < 12; ++i) world.step(solver, h);
  CHECK(world.bodies[1].position.y() < Real(0.491));  // 20 mm too little room, shared
  world.bodies[2].velocity = {0, 1, 0};
  Real highest = 0;
  for (int i = 0; i < 60; ++i) {
    world.step(solver, h);
    highest = std::max(highest, world.bodies[1].position.y());
  }
  CHECK(highest < Real(0.501));  // 34 mm above that, if the normals are swept once
}
