/// Chaplygin's ball: what its equations conserve, Newton's and Euler's equations, which know nothing of them, and solvers that come to the same.
#include "pushback/tools/measure/study/chaplygin.h"

#include <cmath>
#include <random>

#include "pushback/chapters/08_friction_cone/friction_cone.h"
#include "pushback/chapters/19_accuracy_and_time/truth.h"
#include "pushback/chapters/24_half_step/half_step.h"
#include "pushback/tools/measure/study/every_motion.h"
#include "tests/support/catch.h"

using namespace pushback;
using namespace pushback::further;
using Eigen::Vector3d;

namespace {

constexpr int steps_in_a_second = Chaplygin::steps_in_a_frame * frames_per_second;

/// Moments that a body within a ball can have: of three boxes' worth of mass along its axes.
RollingBall random_ball(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> part(0.02, 0.2), number(-1, 1);
  const double radius = 0.2 + 0.4 * part(random), mass = 1 + 50 * part(random);
  const Vector3d squared(part(random), part(random), part(random));  // of the mass's distance from each plane, in r^2
  return {
      .radius = radius,
      .mass = mass,
      .inertia = mass * radius * radius * (Vector3d::Constant(squared.sum()) - squared),
      .orientation = Eigen::Quaterniond(number(random), number(random), number(random), number(random)).normalized(),
      .centre = {0, radius, 0},
      .spin = 5 * Vector3d(number(random), number(random), number(random))};
}

Eigen::Matrix3d inertia_of(const RollingBall& ball) {
  const Eigen::Matrix3d R = ball.orientation.toRotationMatrix();
  return R * ball.inertia.asDiagonal() * R.transpose();
}

/// The force of the contact on the ball, N, but for the weight that it carries: m x'', over 2 dt.
Vector3d friction_on(const RollingBall& ball, double dt) {
  return ball.mass * (ball.after(dt, 4).velocity() - ball.after(-dt, 4).velocity()) / (2 * dt);
}

}  // namespace

TEST_CASE("chaplygin: in body axes K and n obey the equations of 1903, and energy, K.K, K.n and |n| stay") {
  for (unsigned seed = 0; seed < 50; ++seed) {
    INFO(seed);
    const RollingBall ball = random_ball(seed), later = ball.after(2, 2 * steps_in_a_second);
    CHECK(later.energy() == Approx(ball.energy()).epsilon(1e-11));
    CHECK(later.momentum().squaredNorm() == Approx(ball.momentum().squaredNorm()).epsilon(1e-11));
    CHECK(later.momentum().y() == Approx(ball.momentum().y()).margin(1e-11 * ball.momentum().norm()));
    CHECK(later.orientation.norm() == Approx(1).epsilon(1e-14));
    CHECK(later.centre.y() == ball.centre.y());
    constexpr double dt = 1e-4;
    const RollingBall before = ball.after(-dt, 4), after = ball.after(dt, 4);
    const auto in_body = [](const RollingBall& at, const Vector3d& v) {
      return Vector3d(at.orientation.conjugate() * v);
    };
    const Vector3d n = Vector3d::UnitY(), w = in_body(ball, ball.spin), K = in_body(ball, ball.momentum());
    const Vector3d up = in_body(ball, n);
    // The K of the equations, of its own definition.
    CHECK((K - Vector3d(ball.inertia.asDiagonal() * w) - ball.mass * ball.radius * ball.radius * up.cross(w.cross(up)))
              .norm() < 1e-12 * K.norm());
    const Vector3d K_rate = (in_body(after, after.momentum()) - in_body(before, before.momentum())) / (2 * dt);
    CHECK((K_rate - K.cross(w)).norm() < 1e-6 * K.norm() * w.norm());
    CHECK(((in_body(after, n) - in_body(before, n)) / (2 * dt) - up.cross(w)).norm() < 1e-6 * w.norm());
  }
}

TEST_CASE("chaplygin: friction that moves the centre is the one that turns the ball, and the contact stands still") {
  constexpr double dt = 1e-4;
  for (unsigned seed = 0; seed < 50; ++seed) {
    INFO(seed);
    const RollingBall ball = random_ball(seed).after(0.7, steps_in_a_second), before = ball.after(-dt, 4),
                      after = ball.after(dt, 4);
    const Vector3d arm = -ball.radius * Vector3d::UnitY();
    CHECK((ball.velocity() + ball.spin.cross(arm)).norm() < 1e-13);
    CHECK(((after.centre - before.centre) / (2 * dt) - ball.velocity()).norm() < 1e-6 * ball.velocity().norm() + 1e-9);
    const Vector3d turned = (inertia_of(after) * after.spin - inertia_of(before) * before.spin) / (2 * dt);
    const Vector3d moment = arm.cross(friction_on(ball, dt));
    CHECK((turned - moment).norm() < 1e-6 * ball.energy());
  }
}

namespace {

/// m, the farthest that the ball was from its true place in any frame.
template <class ContactSolver>
double error_of(const ContactSolver& given, int substeps) {
  ContactSolver solver = given;
  const Motion& motion = any_motion_named("chaplygin");
  World world;
  motion.begin(world);
  double farthest = 0;
  for (const Places& places : motion.truth(motion.frames())) {
    for (int i = 0; i < substeps; ++i) world.step(solver, 1.0 / (frames_per_second * substeps), 4);
    farthest = std::max(farthest, (world.bodies[1].position - places[1]).norm());
  }
  return farthest;
}

}  // namespace

TEST_CASE("chaplygin: solvers come to the truth, of first order, half steps of second") {
  const auto comes = [](const auto& solver, int order, double most) {
    double before = 0;
    for (const int substeps : {4, 16, 64, 256}) {
      const double error = error_of(solver, substeps);
      INFO(substeps << " substeps: " << error << " m, order " << std::log2(before / error) / 2);
      if (before > 0) CHECK(before / error == Approx(std::pow(4, order)).epsilon(0.03));
      before = error;
    }
    CHECK(before < most);
  };
  comes(Solver<Clamping, Baumgarte, FrictionCone>(), 1, 1.6e-4);
  comes(HalfStep(), 2, 7e-9);
}
