/// Joints: their Jacobians, their freedoms, what their impulses leave alone, and what is refused.
#include <Eigen/QR>

#include "pushback/chapters/13_joints/distance.h"
#include "pushback/chapters/13_joints/weld.h"
#include "pushback/chapters/13_joints/wire.h"
#include "pushback/chapters/14_joints_under_load/jointed_solver.h"
#include "pushback/common/world/measure.h"
#include "tests/support/catch.h"
#include "tests/support/complaint.h"
#include "tests/support/joint_energy.h"
#include "tests/support/joint_jacobian.h"
#include "tests/support/yardstick.h"

using namespace pushback;

namespace {

/// Each joint of two bodies, made where they are.
std::vector<Joint> each_joint(const World& world, int a, int b, Random& random) {
  const Vec3 p = random.direction(), q = p + 6 * random.direction();  // far apart: C is smooth there
  return {distance(world, a, p, b, q), ball_and_socket(world, a, b, p), hinge(world, a, b, p, random.direction()),
          weld(world, a, b, p)};
}

/// Sound all the same where the joint is broken: both are knocked out of place.
void knock(Body& body, Random& random) {
  body.position += Real(0.3) * random.direction();
  const Real angle = random.between(Real(-0.5), Real(0.5));
  body.turned(angle, random.direction());
}

/// (8 (C(t) - C(-t)) - (C(2t) - C(-2t))) / 12t: off by t^4 / 30 of the fifth derivative.
void check_against_finite_differences(const Joint& joint, const Body& a, const Body& b) {
  const Real t = std::pow(eps, Real(0.2));
  const auto at = [&](Real when) { return asked_by(joint, drifted(a, when), drifted(b, when)); };
  const Equations now = asked_by(joint, a, b), ahead = at(t), behind = at(-t), far = at(2 * t), back = at(-2 * t);
  REQUIRE(now.size() == ahead.size());
  for (std::size_t i = 0; i < now.size(); ++i) {
    CAPTURE(joint.name, i);
    const Real rate = (8 * (ahead[i].error - behind[i].error) - (far[i].error - back[i].error)) / (12 * t);
    REQUIRE(std::abs(rate_of(now[i], a, b) + now[i].bias - rate) < Real(1e-8));
  }
}

using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;

/// Of all joints: six columns a body.
Matrix jacobian_of(const World& world) {
  const auto columns = static_cast<Eigen::Index>(6 * world.bodies.size());
  Matrix J(0, columns);
  for (const Joint& joint : world.joints) {
    for (const Equation& equation : asked_by(joint, body_of(world, joint.a), body_of(world, joint.b))) {
      J.conservativeResize(J.rows() + 1, columns);
      J.row(J.rows() - 1).setZero();
      const auto last = J.rows() - 1;
      if (joint.a != the_world)
        J.block(last, 6 * joint.a, 1, 6) << -equation.jacobian.n.transpose(), -equation.jacobian.ra_n.transpose();
      if (joint.b != the_world)
        J.block(last, 6 * joint.b, 1, 6) << equation.jacobian.n.transpose(), equation.jacobian.rb_n.transpose();
    }
  }
  return J;
}
long freedoms(const World& world) {
  const Matrix J = jacobian_of(world);
  return J.cols() - (J.rows() == 0 ? 0 : Eigen::ColPivHouseholderQR<Matrix>(J).rank());
}

Wire ellipse(Real a, Real b) {
  return {.c = [=](Real x, Real y) { return x * x / (a * a) + y * y / (b * b) - 1; },
          .gradient = [=](Real x, Real y) { return Vec3(2 * x / (a * a), 2 * y / (b * b), 0); },
          .drawn = {}};
}

World two_cubes() {
  World world;
  world.gravity.setZero();
  world.add(box(Vec3::Constant(Real(0.5)), 2));
  world.add(box(Vec3::Constant(Real(0.5)), 3).at({Real(1.2), 0, 0}));
  return world;
}

}  // namespace

TEST_CASE("every Matrix is the derivative of its C, where the joint holds and where it is broken") {
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    World world;
    world.add(random.moving_body(2));
    world.add(random.moving_body(2));
    for (Body& body : world.bodies) body.moving(body.velocity / 5).spinning(body.angular_velocity / 5);
    for (const int a : {0, the_world}) {
      for (const Joint& joint : each_joint(world, a, 1, random)) {
        check_against_finite_differences(joint, body_of(world, a), world.bodies[1]);
        Body first = body_of(world, a), second = world.bodies[1];
        if (first.movable()) knock(first, random);
        knock(second, random);
        check_against_finite_differences(joint, first, second);
      }
    }
    const Real angle = random.between(-3, 3);
    const Body on_wire = sphere(Real(0.1), 1).at({2 * std::cos(angle), std::sin(angle), 0}).moving(random.direction());
    World wired;
    wired.add(on_wire);
    check_against_finite_differences(bead_on(wired, ellipse(2, 1), 0), body_of(wired, the_world), wired.bodies[0]);
  }
}

TEST_CASE("a row of a joint, solved once, leaves no speed along itself, be it along a line or about an axis") {
  Random random(5);
  for (int i = 0; i < 200; ++i) {
    World world;
    world.add(random.moving_body(2));
    world.add(random.moving_body(3));
    for (const Joint& joint : each_joint(world, 0, 1, random)) {
      for (const Equation& equation : asked_by(joint, world.bodies[0], world.bodies[1])) {
        World apart = world;
        Row row(apart.bodies[0], apart.bodies[1], equation.jacobian, 0);
        row.solve();
        REQUIRE(std::abs(row.speed()) < Real(1e-12));
        REQUIRE(row.wanted() == Approx(row.impulse));
      }
    }
  }
}

TEST_CASE(
    "a row that gives way ends at J V + b + gamma lambda = 0, wherever it starts, and one with gamma = 0 is a Row") {
  Random random(6);
  for (int i = 0; i < 200; ++i) {
    World world;
    world.add(random.moving_body(2));
    world.add(random.moving_body(3));
    const Equation equation = asked_by(weld(world, 0, 1, random.direction()), world.bodies[0], world.bodies[1])[0];
    Row rigid(world.bodies[0], world.bodies[1], equation.jacobian, 0);
    const Real K = 1 / rigid.effective_mass, gamma = K * random.over_decades(Real(0.01), 100);
    JointRow holds(world.bodies[0], world.bodies[1], equation.jacobian, 0, 0);
    JointRow yields(world.bodies[0], world.bodies[1], equation.jacobian, 0, gamma);
    REQUIRE(yields.effective_mass == Approx(1 / (K + gamma)));
    rigid.bias = holds.bias = yields.bias = random.between(-3, 3);
    rigid.impulse = holds.impulse = yields.impulse = random.between(-10, 10);
    REQUIRE(holds.wanted() == rigid.wanted());
    REQUIRE(holds.error() == rigid.error());
    yields.solve();
    const Real size = std::abs(yields.speed()) + std::abs(yields.bias) + (K + gamma) * (std::abs(yields.impulse) + 10);
    REQUIRE(std::abs(yields.speed() + yields.bias + gamma * yields.impulse) <= 32 * eps * size);
    REQUIRE(yields.error() <= 64 * eps * size);
  }
}

TEST_CASE("a joint leaves 6 - rank J freedoms to a body that hangs on the world") {
  const auto left_by = [](const auto& joint) {
    World world;
    world.add(box({Real(0.3), Real(0.4), Real(0.5)}, 1).at({1, 2, 0}));
    world.joints.push_back(joint(world));
    return freedoms(world);
  };
  const Vec3 p{Real(0.8), 2, Real(0.1)};
  CHECK(left_by([&](World& w) { return bead_on(w, ellipse(std::sqrt(Real(5)), std::sqrt(Real(5))), 0); }) == 4);
  CHECK(left_by([&](World& w) { return distance(w, the_world, {0, 3, 0}, 0, p); }) == 5);
  CHECK(left_by([&](World& w) { return ball_and_socket(w, the_world, 0, p); }) == 3);
  CHECK(left_by([&](World& w) { return hinge(w, the_world, 0, p, {1, 2, 3}); }) == 1);
  CHECK(left_by([&](World& w) { return weld(w, the_world, 0, p); }) == 0);
}

TEST_CASE("a joint between free bodies keeps their momentum, and across a distance their angular momentum") {
  Random random(3);
  for (int i = 0; i < 50; ++i) {
    World world;
    world.gravity.setZero();
    world.add(random.moving_body(2));
    world.add(random.moving_body(2));
    const std::vector<Joint> joints = each_joint(world, 0, 1, random);
    for (const Joint& joint : joints) {
      World one = world;
      one.joints.push_back(joint);
      const Vec3 before = momentum(one), turning = angular_momentum(one);
      JointedSolver solver;
      for (int step = 0; step < 20; ++step) one.step(solver, h, 10);
      CAPTURE(joint.name);
      REQUIRE((momentum(one) - before).norm() < Real(1e-11));
      if (joint.name == "a distance") REQUIRE((angular_momentum(one) - turning).norm() < Real(1e-10));
    }
  }
}

TEST_CASE("what rows that feed nothing back do to the energy is -|dV|^2 / 2, in masses") {
  Random random(4);
  for (int i = 0; i < 20; ++i) {
    World world = crooked_chain(4, random);
    for (Body& body : world.bodies) {
      body.principal_inverse_inertia /= 50;  // light bodies on long arms would take too many sweeps
      body.refresh_inertia();
    }
    Solver<Joints> solver;
    solver.beta = 0;
    world.step(solver, h, 3000);  // whatever velocities it starts with, a solved step has none against the joints
    for (int step = 0; step < 20; ++step) REQUIRE(energy_of_a_step(world, solver, h, 3000).off < Real(1e-9));
  }
}

TEST_CASE("a distance of two points that have come to be one pushes them apart, and nothing is NaN") {
  World world = two_cubes();
  world.joints.push_back(distance(world, 0, {0, 0, 0}, 1, {Real(1.2), 0, 0}));
  world.bodies[1].at({0, 0, 0});
  JointedSolver solver;
  for (int step = 0; step < 300; ++step) world.step(solver, h);
  CHECK(std::abs((world.bodies[1].position - world.bodies[0].position).norm() - (Real(1.2))) < Real(1e-3));
}

TEST_CASE("a weld broken by a right angle about each of its axes comes back, and nothing is NaN") {
  for (int axis = 0; axis < 3; ++axis) {
    World world = two_cubes();
    world.joints.push_back(weld(world, 0, 1, {Real(0.6), 0, 0}));
    world.bodies[1].turned(pi / 2, Vec3::Unit(axis));
    JointedSolver solver;
    for (int step = 0; step < 600; ++step) world.step(solver, h);
    CAPTURE(axis);
    const Equations left = asked_by(world.joints[0], world.bodies[0], world.bodies[1]);
    for (std::size_t i = 3; i < 6; ++i) CHECK(std::abs(left[i].error) < Real(1e-6));
    CHECK(largest_speed(world) < 5);
  }
}

TEST_CASE("joints that cannot be are refused, by name") {
  const World world = two_cubes();
  World fixed = two_cubes();
  fixed.bodies[1].fixed();
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  const Vec3 p{Real(0.6), 0, 0};
  CHECK(complaint([&] { hinge(world, 1, 1, p, Vec3::UnitX()); }) ==
        "a hinge joins body 1 to itself: two different ones are needed");
  CHECK(complaint([&] { weld(world, 0, 2, p); }) ==
        "a weld holds body 2: a body from 0 to 1, or -1 for the world, is needed");
  CHECK(complaint([&] { distance(world, -2, p, 0, p); }) ==
        "a distance holds body -2: a body from 0 to 1, or -1 for the world, is needed");
  CHECK(complaint([&] { ball_and_socket(fixed, the_world, 1, p); }) ==
        "a ball and socket joins bodies -1 and 1, and neither can move: one has to");
  fixed.bodies[1].conveying({1, 0, 0});
  CHECK(complaint([&] { ball_and_socket(fixed, 0, 1, p); }) ==
        "a ball and socket holds body 1, which conveys: one that goes where its velocity points is needed");
  CHECK(complaint([&] { ball_and_socket(world, 0, 1, {0, nan, 0}); }) ==
        "anchor of a ball and socket is (0, nan, 0): three finite numbers are needed");
  CHECK(complaint([&] { hinge(world, 0, 1, p, Vec3::Zero()); }) ==
        "length of the axis of a hinge is 0: a finite number above 0 is needed");
  CHECK(complaint([&] { distance(world, 0, p, 1, p); }) ==
        "length of a distance is 0: a finite number above 0 is needed");
  CHECK(complaint([&] { distance(world, 0, p, 1, 2 * p, -1); }) ==
        "length of a distance is -1: a finite number above 0 is needed");
  CHECK(complaint([&] { bead_on(world, {}, 0); }) == "a wire has no C or no gradient: both are needed");
}

TEST_CASE("a solver that holds no joints refuses a world that has some, and nothing moves") {
  World world = two_cubes();
  world.gravity = {0, -10, 0};
  world.joints.push_back(weld(world, 0, 1, {Real(0.6), 0, 0}));
  FullSolver solver;
  CHECK(complaint([&] { world.step(solver, h); }) ==
        "the world has a weld, and this solver holds no joints: one with the effect Joints is needed, such as "
        "JointedSolver or Recommended");
  static_assert(std::derived_from<JointedSolver, SupportsJoints>);
  CHECK(largest_speed(world) == 0);
}
