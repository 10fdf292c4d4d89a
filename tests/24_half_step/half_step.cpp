/// Chapter 24: the order of the step, what it conserves, and what it refuses.
#include "pushback/chapters/13_joints/distance.h"
#include "pushback/chapters/13_joints/hinge.h"
#include "pushback/chapters/13_joints/weld.h"
#include "pushback/chapters/15_limits_motors_springs/limits.h"
#include "pushback/chapters/15_limits_motors_springs/motor.h"
#include "pushback/chapters/15_limits_motors_springs/piston.h"
#include "pushback/chapters/15_limits_motors_springs/spring.h"
#include "pushback/chapters/19_accuracy_and_time/front.h"
#include "pushback/chapters/19_accuracy_and_time/motion.h"
#include "pushback/chapters/24_half_step/study.h"
#include "pushback/chapters/24_half_step/top.h"
#include "pushback/common/basics/input.h"
#include "pushback/common/bodies/random.h"
#include "pushback/common/world/any_solver.h"
#include "pushback/common/world/forces.h"
#include "pushback/common/world/measure.h"
#include "tests/24_half_step/order.h"
#include "tests/support/catch.h"
#include "tests/support/complaint.h"
#include "tests/support/yardstick.h"

using namespace pushback;
using namespace pushback::half_step_scenes;

namespace {

/// Bodies of any inertia, pinned and hinged to each other.
World tumbling_chain(int count) {
  Random random(5);
  World world;
  Vec3 end = Vec3::Zero();
  for (int link = 0; link < count; ++link) {
    const Vec3 next = end + random.direction();
    world.add(box({Real(0.1), Real(0.2), Real(0.3)}, random.between(1, 3))
                  .oriented(random.orientation())
                  .at((end + next) / 2));
    world.joints.push_back(link % 2 == 0 ? ball_and_socket(world, link - 1, link, end)
                                         : hinge(world, link - 1, link, end, random.direction()));
    for (int before = 0; before < link - 1; ++before) {  // nobody collides: what is asked about here is joints
      Joint apart = ball_and_socket(world, before, link, end);
      apart.ask = [](const Body&, const Body&, const TimeStep&, Equations&) {};
      world.joints.push_back(apart);
    }
    end = next;
  }
  return world;
}

Real farthest(const World& one, const World& other) {
  Real largest = 0;
  for (std::size_t i = 0; i < one.bodies.size(); ++i)
    largest = std::max({largest, (one.bodies[i].position - other.bodies[i].position).norm(),
                        one.bodies[i].orientation.angularDistance(other.bodies[i].orientation)});
  return largest;
}

}  // namespace

TEST_CASE("half step: of second order, and composed of fourth, the pendulum and the chain") {
  if (!in_double) return;  // floats end at about 0.2 mm
  const auto check = [](const char* name, auto step, std::vector<int> substeps, int its_order, int at, Real least) {
    CAPTURE(name, its_order);
    const Motion& motion = motion_named(name);
    const auto truth = motion.truth(motion.frames());
    const auto error_of = [&](int count) { return largest_error(motion, truth, exact(count, step)); };
    CHECK(order(substeps, error_of) == Approx(its_order).margin(its_order == 2 ? 0.1 : 0.2));
    CHECK(error_of(at) < least);
  };
  check("pendulum", HalfStep{}, {4, 8, 16, 32}, 2, 8, 1.9e-5);
  check("chain", HalfStep{}, {4, 8, 16, 32}, 2, 8, 6.1e-5);
  check("pendulum", composed(yoshida), {1, 2, 4, 8}, 4, 8, 1e-6);
  check("pendulum", composed(), {1, 2, 4, 8}, 4, 1, 3e-7);
  check("chain", composed(), {1, 2, 4, 8}, 4, 1, 1.4e-4);
}

TEST_CASE("half step: the plain loop is the same step, and each wrong way is of first order") {
  const plain_24::Bob begin{{std::sin(pi / 3), -std::cos(pi / 3), 0}, Vec3::Zero(), 1};
  const Vec3 down(0, -g, 0);
  World world;
  world.add(sphere(Real(0.1), 1).at(begin.x));
  world.joints.push_back(distance(world, the_world, Vec3::Zero(), 0, begin.x));
  HalfStep step = exact();
  plain_24::Bob bob = begin;
  for (int i = 0; i < 120; ++i) {
    world.step(step, h);
    plain_24::half_step(bob, down, h);
  }
  CHECK((world.bodies[0].position - bob.x).norm() < rounding);
  CHECK((world.bodies[0].velocity - bob.v).norm() < rounding);

  if (!in_double) return;
  const auto truth = [] {
    World reference;
    reference.add(sphere(Real(0.1), 1).at({std::sin(pi / 3), -std::cos(pi / 3), 0}));
    reference.joints.push_back(distance(reference, the_world, Vec3::Zero(), 0, reference.bodies[0].position));
    HalfStep fine = exact(8, composed());
    for (int i = 0; i < 120; ++i) reference.step(fine, h);
    return reference.bodies[0].position;
  }();
  const auto order_of = [&](auto plain_step) {
    return order({4, 8, 16, 32}, [&](int n) {
      plain_24::Bob alone = begin;
      for (int i = 0; i < 120 * n; ++i) plain_step(alone, down, h / static_cast<Real>(n));
      return (alone.x - truth).norm();
    });
  };
  CHECK(order_of(plain_24::half_step) == Approx(2).margin(0.1));
  CHECK(order_of(plain_24::whole_step) == Approx(1).margin(0.1));
  CHECK(order_of(plain_24::average_step) == Approx(1).margin(0.1));
  CHECK(order_of(plain_24::new_rod_step) == Approx(1).margin(0.1));
}

TEST_CASE("half step: a throw is exact, and a spring is of second order and keeps its energy") {
  World thrown;
  thrown.add(sphere(1, 1).at({0, 5, 0}).moving({3, 4, 0}));
  HalfStep step;
  for (int i = 0; i < 60; ++i) thrown.step(step, h);
  CHECK((thrown.bodies[0].position - Vec3(3, 9 - g / 2, 0)).norm() < 100 * eps);

  const auto on_a_spring = [](int substeps, int steps) {
    World world;
    world.gravity.setZero();
    world.add(sphere(1, 1).at({1, 0, 0}));
    world.forces.push_back(spring(0, Vec3::Zero(), 100));  // 10 rad/s
    HalfStep half;
    half.substeps = substeps;
    for (int i = 0; i < steps; ++i) world.step(half, h);
    return world;
  };
  if (in_double) {
    CHECK(order({2, 4, 8, 16}, [&](int n) {
            return std::abs(on_a_spring(n, 60).bodies[0].position.x() - std::cos(Real(10)));
          }) == Approx(2).margin(0.1));
  }
  // v^2 + (1 - (w h / 2)^2) w^2 x^2 is the same after each step, exactly.
  const World later = on_a_spring(1, 3600);
  const Real x = later.bodies[0].position.x(), v = later.bodies[0].velocity.x(), s = 10 * h / 2;
  CHECK(v * v + (1 - s * s) * 100 * x * x == Approx((1 - s * s) * 100).epsilon(in_double ? 1e-11 : 1e-2));
}

TEST_CASE("half step: a force that depends on the velocity is of first order") {
  if (!in_double) return;
  CHECK(order({8, 16, 32, 64}, [](int substeps) {
          World world;
          world.gravity.setZero();
          world.add(sphere(1, 1).moving({1, 0, 0}));
          world.forces.push_back(drag(0, 2));
          HalfStep step;
          step.substeps = substeps;
          for (int i = 0; i < 60; ++i) world.step(step, h);
          return std::abs(world.bodies[0].velocity.x() - std::exp(Real(-2)));
        }) == Approx(1).margin(0.1));
}

TEST_CASE("half step: a free body keeps its momentum and its energy, and tumbles to second order") {
  const auto tumbled = [](int substeps) {
    World world;
    world.gravity.setZero();
    world.add(box({Real(0.1), Real(0.2), Real(0.4)}, 1).spinning({Real(0.1), 5, Real(0.1)}));
    HalfStep step;
    step.substeps = substeps;
    for (int i = 0; i < 120; ++i) world.step(step, h);
    return world;
  };
  World begin;
  begin.add(box({Real(0.1), Real(0.2), Real(0.4)}, 1).spinning({Real(0.1), 5, Real(0.1)}));
  const World later = tumbled(1);
  CHECK((angular_momentum(later) - angular_momentum(begin)).norm() < rounding * angular_momentum(begin).norm());
  CHECK(kinetic_energy(later) == Approx(kinetic_energy(begin)).epsilon(double(rounding)));
  if (!in_double) return;
  const World fine = tumbled(512);
  CHECK(order({4, 8, 16, 32}, [&](int n) {
          return tumbled(n).bodies[0].orientation.angularDistance(fine.bodies[0].orientation);
        }) == Approx(2).margin(0.1));
}

TEST_CASE("half step: a top precesses as the closed form says") {
  const Top top;
  const auto off = [&](int substeps) {
    World world;
    top(world);
    HalfStep step = exact(substeps);
    Real largest = 0;
    for (int i = 0; i < 120; ++i) {
      world.step(step, h);
      largest = std::max(largest, (world.bodies[0].position - Top::stem * top.axis(world.time)).norm());
    }
    return largest;
  };
  CAPTURE(top.spin());
  CHECK(off(8) < (in_double ? Real(8e-5) : Real(1e-3)));
  if (in_double) CHECK(order({4, 8, 16, 32}, off) == Approx(2).margin(0.1));
}

TEST_CASE("half step: joints hold after each step, and so do velocities") {
  World world = tumbling_chain(6);
  HalfStep step;
  step.substeps = 4;
  Residuals worst;
  for (int i = 0; i < 240; ++i) {
    world.step(step, h);
    const Residuals now = residuals(world);
    worst = {std::max(worst.position, now.position), std::max(worst.velocity, now.velocity)};
  }
  CHECK(worst.position <= step.tolerance);
  CHECK(worst.velocity < rounding);
  CHECK(step.stats().rows == 24);
  CHECK(step.stats().residual <= step.tolerance * 4 / h);
}

TEST_CASE("half step: over a minute the energy swings, and does not drift") {
  const auto check = [](World world, int substeps, Real swing, Real drift) {
    HalfStep step = exact(substeps);
    if (in_double) step.tolerance = Real(1e-12);
    const Real before = energy(world);
    Real farthest_off = 0, early = 0, late = 0;
    for (int i = 0; i < 3600; ++i) {
      world.step(step, h);
      const Real off = energy(world) - before;
      farthest_off = std::max(farthest_off, std::abs(off));
      if (i < 600) early += off / 600;
      if (i >= 3000) late += off / 600;
    }
    CAPTURE(before, early, late);
    CHECK(farthest_off < swing);
    CHECK(std::abs(late - early) < drift);
  };
  World pendulum;
  motion_named("pendulum").begin(pendulum);  // 147 J between its highest and its lowest place
  check(pendulum, 1, Real(0.3), in_double ? Real(1e-3) : Real(0.5));
}

TEST_CASE("half step: backwards it finds where it began") {
  const World begin = tumbling_chain(5);
  World world = begin;
  HalfStep step = exact(4);
  const auto go = [&] {
    for (int i = 0; i < 30; ++i) world.step(step, h);
    for (Body& body : world.bodies) body.velocity *= -1, body.angular_velocity *= -1;
  };
  go();
  CHECK(farthest(world, begin) > Real(0.5));
  go();
  CHECK(farthest(world, begin) < (in_double ? Real(1e-9) : Real(0.1)));
}

TEST_CASE("half step: a rod whose length is a function of time is held to second order") {
  const auto at_the_end = [](int substeps) {
    World world;
    world.add(sphere(Real(0.1), 1).at({1, 0, 0}).moving({Real(1.5), 0, 0}));
    world.joints.push_back(
        piston(world, the_world, Vec3::Zero(), 0, {1, 0, 0}, [](Real t) { return 1 + Real(0.5) * std::sin(3 * t); }));
    HalfStep step = exact(substeps);
    for (int i = 0; i < 60; ++i) world.step(step, h);
    CHECK(world.bodies[0].position.norm() ==
          Approx(1 + Real(0.5) * std::sin(Real(3))).epsilon(in_double ? 1e-10 : 1e-5));
    const Real along = world.bodies[0].velocity.dot(world.bodies[0].position.normalized());
    const Real of_substep = h / static_cast<Real>(substeps);
    CHECK(std::abs(along - Real(1.5) * std::cos(Real(3))) < of_substep * of_substep + rounding);
    return world.bodies[0].position;
  };
  if (!in_double) return;
  const Vec3 fine = at_the_end(512);
  CHECK(order({4, 8, 16, 32}, [&](int n) { return (at_the_end(n) - fine).norm(); }) == Approx(2).margin(0.1));
}

TEST_CASE("half step: a step that is too large is divided, or refused by name") {
  World world;
  motion_named("chain").begin(world);
  HalfStep step;
  int halvings = 0;
  for (int i = 0; i < 60; ++i) {
    world.step(step, h);
    halvings += step.halvings();
    REQUIRE(residuals(world).position <= step.tolerance);
  }
  CHECK(halvings > 0);

  World same;
  motion_named("chain").begin(same);
  HalfStep undivided;
  undivided.most_halvings = 0;
  undivided.substeps = 8;  // where one of them fails, those before it are taken back
  std::uint64_t before = 0;
  const std::string said = complaint([&] {
    for (int i = 0; i < 60; ++i) {
      before = hash_of(same);
      same.step(undivided, 8 * h);
    }
  });
  CHECK(said.find("a ball and socket") != std::string::npos);
  CHECK(said.find("more substeps") != std::string::npos);
  CHECK(hash_of(same) == before);
}

TEST_CASE("half step: what it does not do is refused by name, and nothing has changed") {
  using Add = std::function<void(World&)>;
  const auto refused = [](const std::string& part, AnySolver step, const Add& add) {
    World world;
    world.add(sphere(Real(0.2), 1).at({1, 0, 0}).moving({0, 1, 0}));
    add(world);
    const std::uint64_t before = hash_of(world);
    const std::string said = complaint([&] { world.step(step, h); });
    INFO(said);
    CHECK(said.find(part) != std::string::npos);
    CHECK(hash_of(world) == before);
  };
  const auto join = [](auto make) { return [make](World& world) { world.joints.push_back(make(world)); }; };
  const auto limits = [](World& w) { return angle_limits(w, the_world, 0, Vec3::UnitZ(), -1, 1); };
  const auto springs = [](Real hertz) {
    return [hertz](World& w) { return soft(ball_and_socket(w, the_world, 0, Vec3::Zero()), {hertz, 1}); };
  };
  const HalfStep step;
  refused("asleep", step, [](World& world) { world.bodies[0].asleep = true; });
  refused("whose force has a limit", step, join([=](World& w) { return soft(limits(w), {2, 1}); }));
  refused("more substeps", step, join(springs(30)));
  const HalfStep fourth = composed();
  refused("that damps", fourth, join(springs(2)));
  refused("angle limits", fourth, join(limits));
  refused("a motor", fourth, join([](World& w) { return motor_at_speed(w, the_world, 0, Vec3::UnitZ(), 1, 5); }));
  refused("composed step goes back in time", fourth,
          [](World& world) { world.add(half_space(Vec3::UnitX()).at({Real(0.81), 0, 0})); });
  const auto wrong = [&](const std::string& name, auto HalfStepSettings::* setting, auto value) {
    HalfStep with;
    with.*setting = static_cast<std::remove_reference_t<decltype(with.*setting)>>(value);
    refused(name, with, [](World& world) { world.add(half_space(Vec3::UnitX()).at({Real(0.81), 0, 0})); });
  };
  wrong("substeps", &HalfStep::substeps, 0);
  wrong("most_rounds", &HalfStep::most_rounds, 0);
  wrong("most_halvings", &HalfStep::most_halvings, -1);
  wrong("tolerance", &HalfStep::tolerance, 0);
  wrong("threshold", &HalfStep::threshold, -1);
}
