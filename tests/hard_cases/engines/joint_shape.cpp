/// What is read off the equations of a joint is what it was made of.
#include "pushback/tools/measure/peers/joint_shape.h"

#include <cmath>

#include "pushback/chapters/13_joints/hinge.h"
#include "pushback/chapters/15_limits_motors_springs/motor.h"
#include "pushback/chapters/15_limits_motors_springs/ragdoll.h"
#include "pushback/common/bodies/random.h"
#include "tests/support/catch.h"
#include "tests/support/complaint.h"

using namespace pushback;

namespace {

constexpr double exact = 1e-9;

World two_bodies() {
  World world;
  world.add(box({1, 2, 3}, 4).turned(Real(0.8), Vec3(1, 2, 3)).at({1, 2, 3}));
  world.add(sphere(1, 2).turned(Real(1.9), Vec3(3, -1, 1)).at({-3, 1, 2}));
  return world;
}

/// The same axis, or the same one reversed.
bool same_line(const Vec3& one, const Vec3& other) {
  return one.cross(other).norm() < Real(1e-9) && std::abs(one.norm() - 1) < Real(1e-12);
}

}  // namespace

TEST_CASE("a ball and socket, and a hinge: the anchor on either body, and the axis") {
  World world = two_bodies();
  const Vec3 anchor(Real(0.3), -1, 5), axis = Vec3(1, -2, Real(0.5)).normalized();
  const Joint held = ball_and_socket(world, 0, 1, anchor), turning = hinge(world, 0, 1, anchor, axis);
  for (const Joint& joint : {held, turning}) {
    const JointShape shape = shape_of(world, joint);
    CHECK((shape.anchor_a - anchor).norm() < exact);
    CHECK((shape.anchor_b - anchor).norm() < exact);
  }
  CHECK(shape_of(world, held).kind == JointShape::ball_and_socket);
  CHECK(shape_of(world, turning).kind == JointShape::hinge);
  CHECK(same_line(shape_of(world, turning).axis, axis));
  world.bodies[1].position.x() += Real(0.25);  // the gap is there, too
  CHECK((shape_of(world, held).anchor_b - anchor - Vec3(Real(0.25), 0, 0)).norm() < exact);
  const JointShape on_world = shape_of(world, ball_and_socket(world, the_world, 1, anchor));
  CHECK((on_world.anchor_a - anchor).norm() < exact);
}

TEST_CASE("limits of a turn: the axis, and how far it is to either side from where the bodies stand") {
  World world = two_bodies();
  const Vec3 axis = Vec3(2, 1, -1).normalized();
  const Joint twist = twist_limits(world, 0, 1, axis, Real(-0.4), Real(0.7));
  const Joint angle = angle_limits(world, 0, 1, axis, Real(-2), Real(0));  // at one of its limits
  for (const auto& [joint, low, high] : {std::tuple(twist, -0.4, 0.7), std::tuple(angle, -2.0, 0.0)}) {
    const JointShape shape = shape_of(world, joint);
    CHECK(shape.axis.dot(axis) == Approx(1).margin(exact));
    CHECK(shape.low == Approx(low).margin(exact));
    CHECK(shape.high == Approx(high).margin(exact));
  }
  world.bodies[1].turned(Real(0.3), axis);
  CHECK(shape_of(world, twist).high == Approx(0.4).margin(1e-6));
}

TEST_CASE("a cone limit: both directions, and the angle, also where they are one and where a limit is passed") {
  Random random(5);
  for (int i = 0; i < 200; ++i) {
    World world = two_bodies();
    const Vec3 s = random.direction(), u = i % 4 == 0   ? s
                                           : i % 4 == 1 ? Vec3(Vec3::Unit(i / 4 % 3))
                                                        : random.direction();
    const Real half = Real(0.2) + Real(0.012) * static_cast<Real>(i);
    INFO(i);
    const JointShape shape = shape_of(world, cone_limit(world, 0, 1, s, u, half));
    CHECK(shape.kind == JointShape::cone_limit);
    CHECK(same_line(shape.axis, s));
    CHECK((shape.axis.dot(s) * shape.axis_b - u).norm() < Real(1e-7));  // both, or neither, are reversed
    CHECK(shape.high == Approx(half).margin(1e-6));
  }
}

TEST_CASE("a motor at a speed: the axis, the speed and the torque, and one to an angle is named") {
  World world = two_bodies();
  const Vec3 axis = Vec3(2, 1, -1).normalized();
  for (const Real speed : {Real(-2), Real(0.5)}) {
    const JointShape shape = shape_of(world, motor_at_speed(world, 0, 1, axis, speed, 7));
    CHECK(shape.kind == JointShape::motor);
    CHECK(shape.axis.dot(axis) == Approx(1).margin(exact));
    CHECK(shape.speed == Approx(speed).epsilon(exact));
    CHECK(shape.torque == 7);
  }
  const Joint servo = motor_to_angle(world, 0, 1, axis, [](Real) { return Real(0); }, 7);
  CHECK(complaint([&] { shape_of(world, servo); }).find("not possible: a motor to an angle") != std::string::npos);
}

TEST_CASE("every joint of the ragdoll is read, and what is unknown is named") {
  World world;
  limits_motors_springs_scenes::add_ragdoll(world, {0, 1, 0});
  for (const Joint& joint : world.joints) CHECK_NOTHROW(shape_of(world, joint));
  Joint other = world.joints.front();
  other.name = "a rope";
  CHECK(complaint([&] { shape_of(world, other); }).find("not possible: a rope") != std::string::npos);
}
