/// Chapter 25: what a step that is cut at impacts makes exact, and what it bounds.
#include "pushback/engine/half_step/half_step.h"

#include "pushback/chapters/24_half_step/study.h"
#include "pushback/chapters/25_moment_of_impact/plain.h"
#include "pushback/chapters/25_moment_of_impact/scenes.h"
#include "pushback/common/bodies/random.h"
#include "pushback/common/world/measure.h"
#include "pushback/common/world/situations.h"
#include "pushback/engine/half_step/gap.h"
#include "tests/support/catch.h"
#include "tests/support/complaint.h"
#include "tests/support/yardstick.h"

using namespace pushback;
using namespace pushback::half_step_scenes;

namespace {

/// The largest error of a motion of chapter 19, m.
Real error_of_cut(const std::string& name) {
  const Motion& motion = motion_named(name);
  return largest_error(motion, motion.truth(motion.frames()), in_substeps(1, at_impacts()));
}
/// Balls of 1 kg in a row along x, with this much between them; the first one comes with 5 m/s. No gravity.
World row_of_balls(int count, Real gap, Real e) {
  World world;
  world.gravity.setZero();
  for (int i = 0; i < count; ++i)
    world.add(sphere(Real(0.5), 1).at({(1 + gap) * static_cast<Real>(i), 0, 0}).bouncy(e).rough(0));
  world.bodies[0].position.x() -= Real(0.05);
  world.bodies[0].velocity.x() = 5;
  return world;
}
/// A sheet of 1 mm, 1 m high and wide, upright at x = 0.
Body sheet(Real mass) {
  return box({Real(0.0005), Real(0.5), Real(0.5)}, mass);
}

}  // namespace

TEST_CASE("impact: bounces and a break are exact but for rounding, what rests or slides is as before") {
  CHECK(error_of_cut("bounce") < (in_double ? 1e-12 : 1e-3));
  CHECK(error_of_cut("break") < (in_double ? 1e-9 : 1e-2));
  CHECK(error_of_cut("stack-10") < (in_double ? 1e-11 : 1e-3));
  CHECK(error_of_cut("sliding") < 1.7e-4);
}

TEST_CASE("impact: the page's three lines") {
  World world;
  world.add(ground());
  world.add(sphere(Real(0.5), 1).at({0, Real(0.6), 0}).moving({0, -20, 0}).bouncy(Real(0.5)));
  HalfStep solver = at_impacts();
  world.step(solver, 1.0 / 60);
  CHECK(solver.events() == 1);
  CHECK_FALSE(solver.bound_reached());
  // 0.1 m down, h - t up again, with half of what it had
  const Real t = (std::sqrt(400 + Real(0.2) * g) - 20) / g, up = (20 + g * t) / 2, left = h - t;
  CHECK(world.bodies[1].position.y() ==
        Approx(Real(0.5) + up * left - g * left * left / 2).epsilon(in_double ? 1e-9 : 1e-4));
  CHECK(world.bodies[1].velocity.y() == Approx(up - g * left).epsilon(in_double ? 1e-9 : 1e-4));
}

TEST_CASE("impact: infinitely many bounces take t (1 + e) / (1 - e), and then it rests") {
  constexpr Real e = Real(0.8);
  const Real whole = std::sqrt(2 / g) * (1 + e) / (1 - e);  // dropped from 1 m
  World world;
  world.add(ground());
  world.add(sphere(Real(0.5), 2).at({0, Real(1.5), 0}).bouncy(e));
  HalfStep step = in_substeps(1, at_impacts());
  Real rests = 0;
  int events = 0;
  while (world.time < 5) {
    world.step(step, h);
    CHECK_FALSE(step.bound_reached());
    events += step.events();
    if (world.bodies[1].velocity.norm() > (in_double ? Real(1e-9) : Real(1e-3)) ||
        world.bodies[1].position.y() > Real(0.5001))
      rests = world.time;
  }
  CHECK(std::abs(rests - whole) < 2 * h);
  CHECK(std::abs(world.bodies[1].position.y() - Real(0.5)) < (in_double ? Real(1e-8) : Real(1e-4)));
  // 2 u / (g (1 - e)) <= h  ends it:  e^n sqrt(2 g) = h g (1 - e) / 2
  const Real needed = std::log(h * g * (1 - e) / (2 * std::sqrt(2 * g))) / std::log(e);
  CHECK(events == Approx(std::ceil(static_cast<double>(needed))).margin(1));
}

TEST_CASE("impact: a box that lands on an edge is held at its next one") {
  for (const Real tilt : {Real(0.05), Real(0.2), Real(0.5)}) {
    CAPTURE(tilt);
    World world;
    world.add(ground());
    world.add(box(Vec3::Constant(Real(0.5)), 10).turned(tilt, Vec3::UnitZ()).at({0, Real(1.5), 0}));
    HalfStep step = at_impacts();
    Real deepest = 0;
    for (int i = 0; i < 120; ++i) {
      world.step(step, h);
      for (const Vec3& corner : corners_of_core(world.bodies[1]))
        deepest = std::max(deepest, -(world.bodies[1].position + world.bodies[1].orientation * corner).y());
    }
    CHECK(deepest < (in_double ? Real(1e-9) : Real(1e-4)));
  }
}

TEST_CASE("impact: no bullet passes a fixed sheet, whatever its shape, its way and its spin") {
  if (!in_double) return;  // floats end at 1e-5 m, and at 1e-3 m/s
  Random random(7);
  for (int i = 0; i < 300; ++i) {
    CAPTURE(i);
    World world;
    world.add(sheet(1).fixed());
    const Real aim_z = random.between(Real(-0.3), Real(0.3)), aim_y = random.between(Real(-0.3), Real(0.3));
    const Real z = random.between(-1, 1), y = random.between(-1, 1), x = -random.between(1, 4);
    const Vec3 aim(0, aim_y, aim_z), from = aim + Vec3(x, y, z);
    const Real speed = random.between(50, 900);
    Body bullet = i % 2 == 0 ? sphere(Real(0.005), Real(0.01))
                             : box({Real(0.004), Real(0.003), Real(0.005)}, Real(0.01)).oriented(random.orientation());
    world.add(bullet.at(from).moving(speed * (aim - from).normalized()).spinning(random.vector(20)).bouncy(Real(0.3)));
    HalfStep step = at_impacts();
    int events = 0;
    for (int k = 0; k < 12; ++k) {
      world.step(step, h);
      events += step.events();
      CHECK((world.bodies[1].position.x() < Real(-0.003) ||
             world.bodies[1].position.tail<2>().cwiseAbs().maxCoeff() > Real(0.49)));
    }
    CHECK(events > 0);
  }
}

TEST_CASE("impact: a row of balls, in sequence and at the same time: the two differ just where all touch") {
  for (const Impacts impacts : {Impacts::sequential, Impacts::simultaneous})
    for (const Real gap : {Real(0), Real(0.001)}) {
      World world = row_of_balls(5, gap, 1);
      HalfStep step = at_impacts();
      step.impacts = impacts;
      int events = 0;
      for (int i = 0; i < 6; ++i) {
        world.step(step, h);
        events += step.events();
      }
      const bool at_once = impacts == Impacts::simultaneous && gap == 0;
      const auto expected = at_once ? std::array<Real, 5>{-3, 2, 2, 2, 2} : std::array<Real, 5>{0, 0, 0, 0, 5};
      for (std::size_t i = 0; i < 5; ++i)
        CHECK(world.bodies[i].velocity.x() == Approx(expected[i]).margin(in_double ? 1e-8 : 1e-3));
      if (gap == 0) continue;
      CHECK(events == 4);
      // the speed of 5 m/s has been handed on: all gaps together are closed by somebody who has it
      const Real handed = (Real(0.05) + 4 * gap) / 5;
      CHECK(world.bodies[4].position.x() ==
            Approx(4 * (1 + gap) + 5 * (6 * h - handed)).margin(in_double ? 1e-7 : 1e-3));
    }
}

TEST_CASE("impact: where nothing bounces, a row takes on the velocity of its centre of mass at once") {
  for (const int count : {5, 20})  // few contacts, solved from nothing, and many, by blocks
    for (const Impacts impacts : {Impacts::sequential, Impacts::simultaneous}) {
      CAPTURE(count);
      World world = row_of_balls(count, 0, 0);
      HalfStep step = at_impacts();
      step.impacts = impacts;
      step.fall_back_to_full_solve = false;
      for (int i = 0; i < 6; ++i) {
        world.step(step, h);
        for (const Body& ball : world.bodies)
          if (i > 0)
            CHECK(ball.velocity.x() == Approx(Real(5) / static_cast<Real>(count)).epsilon(in_double ? 1e-9 : 1e-3));
      }
    }
}

TEST_CASE("impact: a body of a thousand times the mass lands on another one with little work") {
  World world;
  world.add(ground());
  world.add(box({Real(0.5), Real(0.5), Real(0.5)}, 1).at({0, Real(0.5), 0}));
  world.add(box({Real(0.5), Real(0.5), Real(0.5)}, 1000).at({0, Real(2.5), 0}));
  HalfStep step = at_impacts();
  step.impacts = Impacts::sequential;  // pair by pair this would be thousands of impacts
  double most = 0;
  for (int i = 0; i < 60; ++i) {
    world.step(step, h);
    most = std::max(most, step.work());
  }
  CHECK(world.bodies[2].position.y() == Approx(1.5).margin(1e-4));
  CHECK(most > 0);
  CHECK(most < 1e6);
}

TEST_CASE("impact: what impacts take counts, and a step fails when it is spent") {
  World world;
  world.add(ground().bouncy(1));
  world.add(box({Real(0.5), Real(0.5), Real(0.5)}, 1).at({0, Real(0.5), 0}).bouncy(1));
  world.add(box({Real(0.5), Real(0.5), Real(0.5)}, 1000).at({0, Real(1.51), 0}).moving({0, -5, 0}).bouncy(1));
  World same = world;
  HalfStep step = at_impacts();
  step.impacts = Impacts::sequential;
  CHECK(step.try_step(same, h).converged);
  step.most_work = 1e5;  // the light box hits the others a hundred times
  const StepOutcome outcome = step.try_step(world, h);
  CHECK_FALSE(outcome.converged);
  CHECK(outcome.work < 2e5);
}

TEST_CASE("impact: balls in a box keep their energy, e = 1, and none gets out") {
  Random random(11);
  World world;
  world.gravity.setZero();
  for (int axis = 0; axis < 3; ++axis)
    for (const Real side : {Real(-1), Real(1)}) {
      Body wall = half_space(-side * Vec3::Unit(axis));
      world.add(wall.at(side * Vec3::Unit(axis)).rough(0).bouncy(1));
    }
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      world.add(sphere(Real(0.15), random.between(1, 5))
                    .at({Real(0.5) * static_cast<Real>(x), Real(0.5) * static_cast<Real>(y), 0})
                    .moving(random.vector(20))
                    .rough(0)
                    .bouncy(1));
  HalfStep step = at_impacts();
  const Real begin = kinetic_energy(world);
  int events = 0;
  for (int i = 0; i < 120; ++i) {
    world.step(step, h);
    events += step.events();
    CHECK_FALSE(step.bound_reached());
    for (const Body& body : world.bodies)
      if (body.movable()) CHECK(body.position.cwiseAbs().maxCoeff() < Real(0.85) + (in_double ? 1e-8 : 1e-3));
  }
  CHECK(events > 200);
  CHECK(kinetic_energy(world) == Approx(begin).epsilon(in_double ? 1e-9 : 1e-3));
}

TEST_CASE("impact: with no events allowed it is a half step, and says so") {
  const auto dropped = [] {
    World world;
    world.add(ground());
    world.add(sphere(Real(0.5), 2).at({0, Real(0.6), 0}).moving({0, -20, 0}).bouncy(Real(0.8)));
    return world;
  };
  World cut = dropped(), whole = dropped();
  HalfStep none = at_impacts();
  none.most_events = 0;
  HalfStep half;
  for (int i = 0; i < 3; ++i) {
    cut.step(none, h);
    whole.step(half, h);
    CHECK(none.bound_reached());
    CHECK(none.events() == 0);
  }
  CHECK(hash_of(cut) == hash_of(whole));
}

TEST_CASE("impact: more events than allowed are asked for by a ball between two walls, and nothing gets out") {
  World world;
  world.gravity.setZero();
  world.add(half_space(Vec3::UnitX()).at({-Real(0.51), 0, 0}).bouncy(1).rough(0));
  world.add(half_space(-Vec3::UnitX()).at({Real(0.51), 0, 0}).bouncy(1).rough(0));
  world.add(sphere(Real(0.5), 1).moving({50, 0, 0}).bouncy(1).rough(0));
  HalfStep step = at_impacts();
  world.step(step, h);
  CHECK_FALSE(step.bound_reached());
  CHECK(step.events() == Approx(static_cast<double>(50 * h / Real(0.02))).margin(1));
  step.most_events = 8;
  for (int i = 0; i < 20; ++i) {
    world.step(step, h);
    CHECK(step.bound_reached());
    CHECK(std::abs(world.bodies[2].position.x()) < Real(0.011));
  }
}

TEST_CASE("impact: a negative number of events is refused") {
  World world;
  world.add(sphere(Real(0.5), 1));
  HalfStep step = at_impacts();
  step.most_events = -1;
  CHECK(complaint([&] { world.step(step, h); }).find("most_events is -1") != std::string::npos);
  CHECK(world.bodies[0].position.isZero(0));
}

TEST_CASE("impact: the plain loop is the same step, and a late one is of first order") {
  constexpr Real e = Real(0.7);
  World world;
  world.add(ground());
  world.add(sphere(Real(0.5), 1).at({0, Real(1.5), 0}).bouncy(e));
  HalfStep step = in_substeps(1, at_impacts());
  plain_25::Ball ball{1, 0, e};
  for (int i = 0; i < 200; ++i) {
    world.step(step, h);
    plain_25::cut_step(ball, g, h);
    CHECK(world.bodies[1].position.y() - Real(0.5) == Approx(ball.y).margin(in_double ? 1e-9 : 1e-3));
    CHECK(world.bodies[1].velocity.y() == Approx(ball.v).margin(in_double ? 1e-8 : 1e-2));
  }
  CHECK(ball.y == 0);
  CHECK(ball.v == 0);
  for (const int substeps : {1, 4, 16, 64}) {
    plain_25::Ball late{1, 0, e}, right{1, 0, e};
    for (int i = 0; i < 35 * substeps; ++i) plain_25::late_step(late, g, h / static_cast<Real>(substeps));
    for (int i = 0; i < 35; ++i) plain_25::cut_step(right, g, h);
    CHECK(std::abs(late.y - right.y) < Real(0.1) / static_cast<Real>(substeps));
  }
}

TEST_CASE("impact: the rod is where its closed form has it") {
  const moment_of_impact_scenes::SpinningRod rod;
  World world;
  rod(world);
  HalfStep step = at_impacts();
  step.substeps = 16;
  while (world.time < Real(0.4)) {
    world.step(step, h);
    const Body truth = rod.truth(world.time);
    CHECK((world.bodies[1].position - truth.position).norm() < (in_double ? Real(1e-5) : Real(1e-3)));
    CHECK(world.bodies[1].orientation.angularDistance(truth.orientation) < (in_double ? Real(5e-5) : Real(5e-3)));
  }
}
