/// Extended position based dynamics: what it gets right, and what it does not.
#include "pushback/common/world/measure.h"
#include "tests/methods/played.h"
#include "tests/support/catch.h"
#include "tests/support/complaint.h"
#include "tests/support/on_ground.h"

using namespace pushback;

TEST_CASE("xpbd: an overlap is gone after one step, and has become no speed") {
  for (const Real depth : {Real(0.001), Real(0.05), Real(0.25)}) {
    World world;
    world.gravity.setZero();
    const Body& ball = ball_on_ground(world, depth);
    Xpbd solver;
    world.step(solver, h);
    CHECK(std::abs(depth_of(ball)) < 8 * eps);
    CHECK(largest_speed(world) < 64 * eps);
  }
}

TEST_CASE("xpbd: the bounce is e times the speed before the step, to the last digit") {
  World world;
  Body& ball = ball_on_ground(world, Real(-0.01)).bouncy(Real(0.8)).moving({0, -3, 0});
  Xpbd solver;
  world.step(solver, h);
  CHECK(ball.velocity.y() == Approx(2.4).epsilon(4 * eps));
  CHECK(std::abs(depth_of(ball)) < 8 * eps);
}

// Normal impulses of the pass over velocities carry no friction: with the corners of a sliding box they are 8 % of all.
TEST_CASE("xpbd: a box that slides stops 0.3 m too late, however short the step, since its friction is too small") {
  CHECK(error_of<Xpbd>("sliding", 16, 1) == Approx(0.3).margin(0.01));
  if (in_double) CHECK(error_of<Xpbd>("sliding", 64, 1) == Approx(0.3).margin(0.01));
  World world;
  motion_named("sliding").begin(world);
  auto solver = made<Xpbd>();
  Vec3 sum = Vec3::Zero();
  for (int i = 0; i < 400; ++i) {  // it slides for another 300
    world.step(solver, h / 16);
    for (const Contact& at : world.contacts) sum += at.impulse;
  }
  CHECK(std::abs(sum.y()) == Approx(100 * g * 400 * h / 16).epsilon(0.01));
  CHECK(std::hypot(sum.x(), sum.z()) / std::abs(sum.y()) == Approx(0.46).margin(0.01));  // mu is 0.5
}

TEST_CASE("xpbd: settings that cannot be are refused by name, and so is a joint with a softness") {
  World world;
  ball_on_ground(world, 0);
  const auto refused = [&](const auto& spoil) {
    Xpbd solver;
    spoil(solver);
    return complaint([&] { world.step(solver, h); });
  };
  CHECK(refused([](Xpbd& solver) { solver.substeps = 0; }).find("substeps is 0") != std::string::npos);
  CHECK(refused([](Xpbd& solver) { solver.threshold = -1; }).find("threshold is -1") != std::string::npos);
  world.joints.push_back(
      {"a spring", the_world, 1, [](const Body&, const Body&, const TimeStep&, Equations& equations) {
         equations.push_back({.jacobian = {.n = Vec3::UnitX()}, .softness = 1});
       }});
  CHECK(refused([](Xpbd&) {}).find("a spring is a joint with") != std::string::npos);
}
