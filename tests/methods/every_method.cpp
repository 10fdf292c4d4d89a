/// What every method of tools/methods is held to.
#include "pushback/chapters/13_joints/scenes.h"
#include "pushback/common/world/any_solver.h"
#include "pushback/common/world/measure.h"
#include "tests/methods/played.h"
#include "tests/support/catch.h"
#include "tests/support/complaint.h"
#include "tests/support/on_ground.h"

using namespace pushback;

namespace {

Real energy(const World& world) {
  return kinetic_energy(world) + potential_energy(world);
}

}  // namespace

#define COULOMBS Xpbd, Avbd, ConjugateSolver, SapLagged  // whose friction is not relaxed
#define EVERY_METHOD COULOMBS, Sap

TEMPLATE_TEST_CASE("methods: a copy goes on in the bits of the original", "", EVERY_METHOD) {
  World one;
  heap(one, 2, 3, Real(-0.5));
  auto solver = made<TestType>();
  for (int i = 0; i < 60; ++i) one.step(solver, h, 10);
  World copy = one;
  AnySolver copied = solver;
  for (int i = 0; i < 60; ++i) {
    one.step(solver, h, 10);
    copy.step(copied, h, 10);
  }
  CHECK(hash_of(one) == hash_of(copy));
}

TEMPLATE_TEST_CASE("methods: a ball at rest stays where it is", "", EVERY_METHOD) {
  World world;
  const Vec3 place = ball_on_ground(world, Real(1e-4)).position;  // the slop of those that have one
  auto solver = made<TestType>();
  for (int i = 0; i < 300; ++i) world.step(solver, h, 4);
  const bool pushes_out =
      std::same_as<TestType, Xpbd> || std::same_as<TestType, Avbd> || std::derived_from<TestType, Sap>;
  CHECK((world.bodies[1].position - place).norm() <= (pushes_out ? Real(1.0001e-4) : tiny));
  CHECK(largest_speed(world) < Real(1e-6));
}

// 5/7 of the speed, and its way until there: a single contact, whose friction is mu times its normal impulse.
TEMPLATE_TEST_CASE("methods: a ball slides, then rolls, by an error of the order of the step", "", COULOMBS) {
  if (!in_double) return;  // velocities that are differences of floats: Xpbd has no order there
  const double coarse = error_of<TestType>("rolling", 4, 16), fine = error_of<TestType>("rolling", 8, 16);
  CHECK(coarse < 0.004);
  CHECK(std::log2(coarse / fine) == Approx(1).margin(0.05));
}

TEMPLATE_TEST_CASE("methods: a box slides and stops, by an error of the order of the step", "", Avbd, ConjugateSolver,
                   SapLagged) {
  if (!in_double) return;
  const double coarse = error_of<TestType>("sliding", 4, 16), fine = error_of<TestType>("sliding", 8, 16);
  CHECK(coarse < 0.013);
  CHECK(std::log2(coarse / fine) == Approx(1).margin(0.05));
}

TEMPLATE_TEST_CASE("methods: a bounce, by an error of the order of the step", "", Xpbd, ConjugateSolver) {
  if (!in_double) return;
  const double coarse = error_of<TestType>("bounce", 16, 4), fine = error_of<TestType>("bounce", 256, 4);
  CHECK(coarse < 0.03);
  CHECK(std::log2(coarse / fine) / 4 == Approx(1).margin(0.15));
}

// What the two do to each other changes nothing of their sum, where every impulse acts on both.
TEMPLATE_TEST_CASE("methods: two free bodies keep their momentum", "", Xpbd, ConjugateSolver, Sap, SapLagged) {
  for (const int parts : {1, 8}) {
    World world;
    world.gravity.setZero();
    world.add(box({Real(0.5), Real(0.3), Real(0.4)}, 5).at({0, 0, 0}).spinning({1, 2, 0}));
    world.add(sphere(Real(0.4), 2).at({Real(0.1), 1, 0}).moving({0, -3, 1}).bouncy(Real(0.5)));
    auto solver = made<TestType>();
    const Vec3 before = momentum(world), turning = angular_momentum(world);
    Real pushed = 0;
    for (int i = 0; i < 60 * parts; ++i) {
      world.step(solver, h / static_cast<Real>(parts), 10);
      for (const Contact& at : world.contacts) pushed += at.impulse.norm();
    }
    CHECK(pushed > 1);
    CHECK((momentum(world) - before).norm() < tiny);
    // Xpbd pushes bodies where they are now, and turns them by what is no vector: of an impact that loses so much of a turn.
    const Real lost = std::same_as<TestType, Xpbd> ? Real(0.1) / static_cast<Real>(parts) : tiny;
    CHECK((angular_momentum(world) - turning).norm() < lost);
  }
}

TEMPLATE_TEST_CASE("methods: boxes that fall on each other gain no energy", "", EVERY_METHOD) {
  World world;
  world.add(ground());
  for (int i = 0; i < 8; ++i) {
    const Real where = static_cast<Real>(i);
    world.add(box(Vec3::Constant(Real(0.5)), 100)
                  .turned(where, Vec3(1, where, 2).normalized())
                  .at({Real(0.3) * std::cos(2 * where), 1 + Real(1.8) * where, Real(0.3) * std::sin(2 * where)}));
  }
  auto solver = made<TestType>();
  const Real first = energy(world);
  Real before = first;
  for (int i = 0; i < 900; ++i) {
    world.step(solver, h / 4, 10);
    REQUIRE(energy(world) <= first);
    before = energy(world);
  }
  CHECK(before < first / 3);
}

TEMPLATE_TEST_CASE("methods: a scene that cannot be simulated is refused, and nobody has moved", "", EVERY_METHOD) {
  World world;
  Body& ball = ball_on_ground(world, 0);
  auto solver = made<TestType>();
  CHECK(complaint([&] { world.step(solver, -1, 1); }).find("dt is -1") != std::string::npos);
  CHECK(complaint([&] { world.step(solver, h, -3); }).find("sweeps is -3") != std::string::npos);
  ball.velocity.x() = std::numeric_limits<Real>::quiet_NaN();
  const Vec3 place = ball.position;
  CHECK(complaint([&] { world.step(solver, h, 1); }).find("velocity") != std::string::npos);
  CHECK(world.bodies[1].position == place);
}

TEMPLATE_TEST_CASE("methods: a pendulum by an error of the order of the step, and joints that hold a hundredfold mass",
                   "", Xpbd, Avbd, Sap) {
  constexpr bool xpbd = std::same_as<TestType, Xpbd>, avbd = std::same_as<TestType, Avbd>;
  const int sweeps = avbd ? 4 : 1;
  if (in_double && !xpbd) {
    const double coarse = error_of<TestType>("pendulum", 8, sweeps), fine = error_of<TestType>("pendulum", 16, sweeps);
    CHECK(std::log2(coarse / fine) == Approx(1).margin(0.1));
  }
  World world;
  any_motion_named("chain").begin(world);
  TestType solver;
  if constexpr (xpbd) solver.substeps = 64;
  const int parts = xpbd ? 1 : 16;
  Real farthest = 0;
  for (int i = 0; i < 120 * parts; ++i) {
    world.step(solver, h / static_cast<Real>(parts), sweeps);
    farthest = std::max(farthest, joints_scenes::largest_joint_error(world));
  }
  CHECK(farthest < (xpbd ? Real(1.5e-3) : avbd ? Real(0.01) : Real(1e-3)));
}
