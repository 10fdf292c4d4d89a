/// Chapter 25: bodies that are joined are cut at their impacts, too.
#include "pushback/chapters/13_joints/ball_and_socket.h"
#include "pushback/chapters/13_joints/distance.h"
#include "pushback/chapters/13_joints/weld.h"
#include "pushback/chapters/15_limits_motors_springs/piston.h"
#include "pushback/chapters/19_accuracy_and_time/truth.h"
#include "pushback/chapters/24_half_step/study.h"
#include "pushback/chapters/25_moment_of_impact/scenes.h"
#include "pushback/common/bodies/random.h"
#include "pushback/common/world/any_solver.h"
#include "pushback/common/world/situations.h"
#include "pushback/engine/half_step/half_step.h"
#include "tests/24_half_step/order.h"
#include "tests/support/catch.h"

using namespace pushback;
using moment_of_impact_scenes::PendulumAtWall;

namespace {

HalfStep in_parts(int substeps) {
  return half_step_scenes::in_substeps(substeps, at_impacts());
}
/// rad: how far the ball on a pin has turned.
double angle_of(const World& world) {
  return static_cast<double>(std::atan2(world.bodies[0].position.x(), -world.bodies[0].position.y()));
}
/// rad/s: of the ball on a pin, by its energy. It is let go at PendulumAtWall::angle.
///   7/5 m r^2 w^2 / 2 = m g r (cos a - cos a_0)
double speed_at(double angle) {
  const double from = static_cast<double>(PendulumAtWall::angle), r = static_cast<double>(PendulumAtWall::radius);
  return std::sqrt(2 * truth::g * (std::cos(angle) - std::cos(from)) / (1.4 * r));
}
/// s: until it is there, on its way to the wall. With a = a_0 + s^2 nothing is infinite; Simpson's rule.
double time_to(double angle) {
  const double from = static_cast<double>(PendulumAtWall::angle), end = std::sqrt(angle - from);
  constexpr int parts = 2000;
  const auto slope = [&](double s) {
    const double at_rest = std::sqrt(2 * 1.4 * static_cast<double>(PendulumAtWall::radius) /
                                     (truth::g * std::sin(-from)));  // its limit for s = 0
    return s == 0 ? at_rest : 2 * s / speed_at(from + s * s);
  };
  double sum = 0;
  for (int i = 0; i <= parts; ++i) sum += (i == 0 || i == parts ? 1 : i % 2 == 1 ? 4 : 2) * slope(end * i / parts);
  return sum * end / parts / 3;
}
double touching_angle(const PendulumAtWall& scene) {
  return std::asin(static_cast<double>(scene.wall / PendulumAtWall::radius) - 1);
}

}  // namespace

TEST_CASE("joined impact: a ball on a pin meets a wall at the instant and with the speed of the closed form") {
  for (const Real e : {Real(0.5), Real(1)}) {
    const PendulumAtWall scene{.links = 0, .e = e};
    const double angle = touching_angle(scene), meets = time_to(angle);
    const auto off = [&](int substeps) {
      World world;
      scene(world);
      HalfStep step = in_parts(substeps);
      while (step.events() == 0) world.step(step, h);
      REQUIRE(step.events() == 1);
      const Body& ball = world.bodies[0];
      // Back from where it is now: it left with e times the speed with which it came.
      const double now = angle_of(world), speed = static_cast<double>(ball.angular_velocity.z());
      const double leaves = std::sqrt(speed * speed + 2 * truth::g * (std::cos(angle) - std::cos(now)) /
                                                          (1.4 * static_cast<double>(PendulumAtWall::radius)));
      const double of_speed = std::abs(leaves / (static_cast<double>(e) * speed_at(angle)) - 1);
      CHECK(of_speed < 0.02 / (substeps * substeps));
      CHECK(speed < 0);
      return of_speed;
    };
    if (!in_double) return;
    CHECK(order({4, 8, 16, 32}, off) == Approx(2).margin(0.2));
    World world;
    scene(world);
    HalfStep step = in_parts(64);
    while (step.events() == 0) world.step(step, h);
    if (e == 1) {  // on its way back it passes each place as long after the impact as it did before
      const double met = (static_cast<double>(world.time) + time_to(angle_of(world))) / 2;
      CHECK(met == Approx(meets).epsilon(1e-5));
    }
  }
}

TEST_CASE("joined impact: a double pendulum that meets a wall is off by the square of the substep") {
  const PendulumAtWall scene{.links = 1};
  const Motion motion{.name = "", .title = "", .fill = scene, .seconds = 2, .truth = {}};
  const std::vector<Places> truth = scene.truth(120);
  const auto error = [&](int substeps) { return half_step_scenes::largest_error(motion, truth, in_parts(substeps)); };
  CHECK(error(16) < (in_double ? 1e-3 : 1e-2));
  if (!in_double) return;
  CHECK(order({8, 16, 32, 64}, error) == Approx(2).margin(0.2));
}

// Between its ends a part is off by no more than 2/81 h^3 max |x'''|, as a parabola through x(0), x'(0) and x(h) is.
TEST_CASE("joined impact: what touches only within a step may be missed, by less than the parabola's bound") {
  if (!in_double) return;
  const auto is_seen = [](Real hertz, Real phase, Real overlap, int substeps) {
    const Real w = 2 * pi * hertz, reach = Real(0.1), radius = Real(0.05);
    const auto length = [=](Real t) { return 1 + reach * std::sin(w * t - phase); };
    World world;
    world.gravity.setZero();
    world.add(sphere(radius, 1).at({length(0), 0, 0}).moving({w * reach * std::cos(phase), 0, 0}).rough(0));
    world.add(sphere(radius, 1).at({1 + reach + 2 * radius - overlap, 0, 0}).rough(0));
    world.joints.push_back(piston(world, the_world, Vec3::Zero(), 0, {length(0), 0, 0}, length));
    HalfStep step = in_parts(substeps);
    while (world.time * hertz < Real(0.99) && step.events() == 0) world.step(step, h);
    return step.events() > 0;
  };
  const auto missed = [&](Real hertz, int substeps) {  // m
    Real most = 0;
    for (int part = 0; part < 8; ++part) {
      Real unseen = 0, seen = Real(0.05);
      while (seen - unseen > Real(1e-9)) {
        const Real middle = (unseen + seen) / 2, phase = Real(0.6) + pi / 4 * hertz * h * static_cast<Real>(part);
        (is_seen(hertz, phase, middle, substeps) ? seen : unseen) = middle;
      }
      most = std::max(most, unseen);
    }
    return most;
  };
  for (const Real hertz : {Real(5), Real(20)}) {
    const Real bound = Real(0.2) * std::pow(2 * pi * hertz * h, Real(3)) / 81, most = missed(hertz, 1);
    CHECK(most < bound);
    CHECK(most > bound / 8);
  }
  CHECK(missed(10, 1) == Approx(0.0014).epsilon(0.1));  // the page says so, and the next too
  CHECK(missed(10, 1) > 12 * missed(10, 2));
  CHECK_FALSE(is_seen(60, pi / 2, Real(0.19), 1));
  CHECK(is_seen(60, pi / 2, Real(0.02), 2));
}

TEST_CASE("joined impact: what is pressed to a wall comes to rest there, and bounces end") {
  // The ball hangs beyond the wall: it would rest at 0, and the wall holds it at -30 degrees.
  PendulumAtWall scene{.links = 0, .e = Real(0.5), .wall = Real(0.1)};
  World world;
  scene(world);
  HalfStep step = in_parts(1);
  int events = 0;
  for (int i = 0; i < 180; ++i) {
    world.step(step, h);
    events += step.events();
    CHECK_FALSE(step.bound_reached());
  }
  // Ends where gravity could bring it back for ever within a step: 2 u <= g h (1 - e).
  const double angle = touching_angle(scene),
               meets = speed_at(angle) * static_cast<double>(PendulumAtWall::radius) * std::cos(angle);
  CHECK(events == std::ceil(std::log(truth::g * static_cast<double>(h) / (4 * meets)) / std::log(0.5)));
  CHECK(world.bodies[0].velocity.norm() < (in_double ? Real(1e-8) : Real(1e-3)));
  CHECK(angle_of(world) == Approx(angle).margin(in_double ? 1e-7 : 1e-3));
}

TEST_CASE("joined impact: two dumbbells that meet keep momentum, angular momentum and energy") {
  for (const bool of_rods : {false, true}) {
    World world;
    world.gravity.setZero();
    const auto dumbbell = [&](const Vec3& at, const Vec3& velocity) {
      const int one = world.add(sphere(Real(0.1), 1).at(at).moving(velocity).rough(0).bouncy(1));
      const Vec3 end = at + Vec3(Real(0.3), Real(0.4), 0);
      const int two = world.add(sphere(Real(0.1), 2).at(end).moving(velocity).rough(0).bouncy(1));
      world.joints.push_back(of_rods ? distance(world, one, at, two, end) : weld(world, one, two, (at + end) / 2));
    };
    dumbbell({0, 0, 0}, {3, 0, 0});
    dumbbell({1, Real(0.35), Real(0.05)}, {-2, 0, Real(0.1)});
    const Vec3 p = momentum(world), l = angular_momentum(world);
    const Real begin = kinetic_energy(world);
    HalfStep step = in_parts(8);
    int events = 0;
    for (int i = 0; i < 60; ++i) {
      world.step(step, h);
      events += step.events();
    }
    CHECK(events > 0);
    CHECK((momentum(world) - p).norm() < 100 * rounding);
    CHECK((angular_momentum(world) - l).norm() < 100 * rounding);
    CHECK(kinetic_energy(world) == Approx(begin).epsilon(in_double ? 1e-5 : 1e-3));
  }
}

TEST_CASE("joined impact: the joint bears its part of an impact, and says so") {
  // A rod from a pin down to a ball, which the wall stops: e = 0. Both have their part of the ball's momentum.
  World world;
  world.gravity.setZero();
  const Vec3 along = Vec3(1, -1, 0).normalized();
  const int ball = world.add(sphere(Real(0.1), 2).at(along).moving(3 * Vec3(1, 1, 0).normalized()).rough(0));
  world.bodies[0].principal_inverse_inertia.setZero();
  world.add(half_space(-Vec3::UnitX()).at({along.x() + Real(0.1), 0, 0}).rough(0));
  world.joints.push_back(distance(world, the_world, Vec3::Zero(), ball, along));
  HalfStep step = in_parts(1);
  world.step(step, h);
  CHECK(step.events() == 1);
  CHECK(step.dissipated_energy() == Approx(2 * 9 / 2.0).epsilon(in_double ? 1e-9 : 1e-4));  // m v^2 / 2, all of it
  CHECK(world.bodies[0].velocity.norm() < rounding);
  // m v + L along n + l along the rod = 0:  n = -x, rod = (1, -1) / sqrt(2), v = 3 (1, 1) / sqrt(2)
  //   y: 6 / sqrt(2) - l / sqrt(2) = 0,  l = 6;     x: 6 / sqrt(2) - L + l / sqrt(2) = 0,  L = 12 / sqrt(2)
  REQUIRE(world.contacts.size() == 1);
  CHECK(world.contacts[0].impulse.norm() == Approx(12 / std::sqrt(2.0)).epsilon(in_double ? 1e-9 : 1e-4));
  CHECK(std::abs(world.joints[0].impulses[0]) == Approx(6).epsilon(in_double ? 1e-9 : 1e-4));
}

TEST_CASE("joined impact: what impacts take of the energy is the part 1 - e^2, and what is held is known") {
  for (const bool joined : {false, true})
    for (const Real e : {Real(0), Real(0.5), Real(1)}) {
      CAPTURE(joined, e);
      World world;
      world.add(ground().bouncy(e).rough(0));
      world.add(sphere(Real(0.1), 2).at({0, Real(0.3), 0}).bouncy(e).rough(0));
      if (joined) world.add(sphere(Real(0.1), 3).at({0, Real(0.8), 0}));
      if (joined) world.joints.push_back(weld(world, 1, 2, {0, Real(0.5), 0}));
      HalfStep step = in_parts(1);
      const Real fall = (joined ? 5 : 2) * g * Real(0.2);  // J, until it touches
      int steps = 0;
      for (; step.events() == 0 && steps < 60; ++steps) {
        CHECK(step.dissipated_energy() == 0);
        CHECK_FALSE(step.contacts_held());
        world.step(step, h);
      }
      CHECK(step.dissipated_energy() ==
            Approx((1 - e * e) * fall).epsilon(in_double ? 1e-6 : 1e-3).margin(in_double ? 1e-9 : 1e-3));
      CHECK(step.contacts_held() == (e == 0));
      if (e > 0) continue;
      world.step(step, h);
      CHECK(step.events() == 0);
      CHECK(step.dissipated_energy() == 0);
      CHECK(step.contacts_held());
    }
}
