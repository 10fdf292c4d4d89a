/// Chapter 24: joints, limits, motors and contacts in one stage; springs.
#include "pushback/chapters/13_joints/distance.h"
#include "pushback/chapters/13_joints/hinge.h"
#include "pushback/chapters/13_joints/weld.h"
#include "pushback/chapters/15_limits_motors_springs/limits.h"
#include "pushback/chapters/15_limits_motors_springs/piston.h"
#include "pushback/chapters/15_limits_motors_springs/spring.h"
#include "pushback/chapters/24_half_step/on_floor.h"
#include "pushback/common/basics/input.h"
#include "pushback/common/world/measure.h"
#include "tests/24_half_step/order.h"
#include "tests/support/catch.h"

using namespace pushback;

namespace {

Real error_on_floor(const half_step_scenes::OnFloor& round, int substeps) {
  World world;
  round(world);
  HalfStep step = exact(substeps);
  Real largest = 0;
  for (int i = 0; i < 30; ++i) {
    world.step(step, h);
    largest = std::max(largest, (world.bodies[1].position - round.place(world.time)).norm());
  }
  return largest;
}

}  // namespace

TEST_CASE("half step: a bob on a rod slides round on a floor, of second order, with friction and without") {
  for (const Real mu : {Real(0), Real(0.2)}) {
    CAPTURE(mu);
    const half_step_scenes::OnFloor round{mu};
    CHECK(error_on_floor(round, 4) < 1e-3);
    if (in_double)
      CHECK(order({4, 8, 16, 32}, [&](int n) { return error_on_floor(round, n); }) == Approx(2).margin(0.1));
  }
}

TEST_CASE("half step: two boxes that are welded rest as one, and slide as far as one") {
  World rest;
  rest.add(ground());
  for (const Real x : {Real(-0.5), Real(0.5)}) rest.add(box(Vec3::Constant(Real(0.5)), 3).at({x, Real(0.5), 0}));
  rest.joints.push_back(weld(rest, 1, 2, {0, Real(0.5), 0}));
  World slide = rest;
  const World begin = rest;
  HalfStep step;
  for (int i = 0; i < 300; ++i) rest.step(step, h);
  for (std::size_t i = 1; i < rest.bodies.size(); ++i) {
    CHECK((rest.bodies[i].position - begin.bodies[i].position).norm() < rounding);
    CHECK(rest.bodies[i].orientation.angularDistance(begin.bodies[i].orientation) < rounding);
  }
  Real carried = 0;
  for (const Contact& contact : rest.contacts) carried += contact.impulse.y();
  CHECK(carried == Approx(6 * g * h).epsilon(in_double ? 1e-9 : 1e-3));

  for (Body& body : slide.bodies)
    if (body.movable()) body.velocity = {4, 0, 0};
  step.substeps = 4;
  for (int i = 0; i < 120; ++i) slide.step(step, h);
  const Real mu = Real(0.5), of_substep = h / 4;  // as far as v^2 / (2 mu g), exactly until the step in which it stops
  CHECK(std::abs(slide.bodies[1].position.x() + Real(0.5) - 16 / (2 * mu * g)) <=
        mu * g * of_substep * of_substep / 8 + rounding);
  CHECK(slide.bodies[1].velocity.norm() < rounding);
}

TEST_CASE("half step: a pendulum stops at its limit, and rests on it") {
  World world;
  world.add(sphere(Real(0.1), 2).at({1, 0, 0}));
  world.joints.push_back(hinge(world, the_world, 0, Vec3::Zero(), Vec3::UnitZ()));
  world.joints.push_back(angle_limits(world, the_world, 0, Vec3::UnitZ(), Real(-0.7), 1));
  HalfStep step;
  Real lowest = 0;
  for (int i = 0; i < 120; ++i) {
    world.step(step, h);
    const Vec3& place = world.bodies[0].position;
    lowest = std::min(lowest, std::atan2(place.y(), place.x()));
  }
  CHECK(lowest > Real(-0.7) - (in_double ? Real(1e-5) : Real(1e-4)));
  const Vec3 at(std::cos(Real(0.7)), -std::sin(Real(0.7)), 0);
  CHECK((world.bodies[0].position - at).norm() < (in_double ? Real(1e-7) : Real(1e-4)));
  CHECK(world.bodies[0].velocity.norm() < (in_double ? Real(1e-7) : Real(1e-4)));
  CHECK(world.joints[1].impulses[0] == Approx(2 * g * std::cos(Real(0.7)) * h).epsilon(1e-3));
  CHECK(world.joints[1].impulses[1] == 0);
}

TEST_CASE("half step: a motor at the limit of its force lifts as far as that goes, and then as fast as it is to") {
  const auto upwards = [](Real t) { return 1 + t; };
  World world;
  world.add(sphere(Real(0.1), 2).at({0, 1, 0}));
  world.joints.push_back(piston(world, the_world, Vec3::Zero(), 0, {0, 1, 0}, upwards, 30));
  HalfStep step;
  const Real a = 15 - g;
  for (int i = 0; i < 6; ++i) world.step(step, h);
  CHECK(world.bodies[0].position.y() == Approx(1 + a * world.time * world.time / 2).epsilon(in_double ? 1e-12 : 1e-5));
  CHECK(world.bodies[0].velocity.y() == Approx(a * world.time).epsilon(in_double ? 1e-12 : 1e-5));
  CHECK(world.joints[0].impulses[0] == Approx(30 * h).epsilon(in_double ? 1e-12 : 1e-5));
  Real behind = 1;
  for (int i = 0; i < 294; ++i) {  // it never overshoots: what is left becomes less
    world.step(step, h);
    const Real now = 1 + world.time - world.bodies[0].position.y();
    CHECK((now > -rounding && now < behind + rounding));
    if (world.bodies[0].velocity.y() > Real(0.999)) behind = now;
  }
  CHECK(std::abs(behind) < rounding);
  CHECK(world.bodies[0].velocity.y() == Approx(1).epsilon(in_double ? 1e-9 : 1e-4));
  CHECK(world.joints[0].impulses[0] == Approx(2 * g * h).epsilon(in_double ? 1e-6 : 1e-3));

  World weak;  // less than the weight: it falls with what is left of g
  weak.add(sphere(Real(0.1), 2).at({0, 1, 0}));
  weak.joints.push_back(piston(weak, the_world, Vec3::Zero(), 0, {0, 1, 0}, upwards, 10));
  for (int i = 0; i < 12; ++i) weak.step(step, h);
  CHECK(weak.bodies[0].position.y() ==
        Approx(1 - (g - 5) * weak.time * weak.time / 2).epsilon(in_double ? 1e-12 : 1e-5));
}

TEST_CASE("half step: a mass on a spring, of second order, damped or not") {
  const Spring spring{Real(1.5), 0};
  for (const Real damping : {Real(0), Real(0.2)}) {
    CAPTURE(damping);
    const Real w = 2 * pi * spring.hertz, fall = damping * w, turn = w * std::sqrt(1 - damping * damping);
    const auto error = [&](int substeps) {
      World world;
      world.gravity.setZero();
      world.add(sphere(Real(0.1), 2).at({0, 1, 0}));
      world.joints.push_back(
          soft(distance(world, the_world, Vec3::Zero(), 0, {0, 1, 0}, Real(0.8)), {spring.hertz, damping}));
      HalfStep step = exact(substeps);
      Real largest = 0;
      for (int i = 0; i < 60; ++i) {
        world.step(step, h);
        const Real t = world.time;
        const Real truth =
            Real(0.8) + Real(0.2) * std::exp(-fall * t) * (std::cos(turn * t) + fall / turn * std::sin(turn * t));
        largest = std::max(largest, std::abs(world.bodies[0].position.y() - truth));
      }
      return largest;
    };
    CHECK(error(1) < 2e-3);
    if (in_double) CHECK(order({2, 4, 8, 16}, error) == Approx(2).margin(0.1));
  }
}

TEST_CASE("half step: a spring knows what it bore, hangs as deep as its force says, and holds with contacts as well") {
  World world;
  world.add(ground().rough(0));
  world.add(box(Vec3::Constant(Real(0.5)), 10).at({0, Real(0.5), 0}).rough(0));
  world.add(sphere(Real(0.1), 2).at({0, 3, 0}));
  world.joints.push_back(soft(distance(world, the_world, {0, 4, 0}, 2, {0, 3, 0}), {2, 1}));
  world.joints.push_back(soft(distance(world, the_world, {0, 5, 0}, 1, {0, 1, 0}), {Real(0.5), 1}));
  HalfStep step;
  for (int i = 0; i < 300; ++i) world.step(step, h);
  const Real w = 4 * pi;
  CHECK(world.bodies[2].position.y() == Approx(3 - g / (w * w)).epsilon(1e-6));
  CHECK(world.joints[0].impulses[0] == Approx(-2 * g * h).epsilon(1e-6));
  CHECK((world.bodies[1].position - Vec3(0, Real(0.5), 0)).norm() < rounding);
}
