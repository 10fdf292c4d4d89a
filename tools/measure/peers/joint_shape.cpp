#include "pushback/tools/measure/peers/joint_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "pushback/common/world/world.h"
#include "pushback/tools/measure/peers/engine.h"

namespace pushback {

namespace {

constexpr Real instant = Real(1) / 60;  // s, of the step that a limit is asked about; any will do

/// r, of the three r x e_x, r x e_y, r x e_z.
Vec3 arm_of(const Vec3& across_x, const Vec3& across_y, const Vec3& across_z) {
  return {across_y.z(), across_z.x(), across_x.y()};
}

/// How far an inequality between turns is from its limit, rad: see at_least_zero in chapter 15.
Real left_of(const Equation& equation) {
  return equation.bias != 0 ? equation.bias * instant : equation.error;
}

Equations asked(const Joint& joint, const Body& a, const Body& b) {
  Equations equations;
  joint.ask(a, b, {0, instant}, equations);
  return equations;
}

/// The gradient of the angle between s, which A carries, and u, which B carries, is s x u by its length: with B turned in several
/// ways it is always across s, and with A turned across u.
class Cone {
 public:
  Cone(const Joint& joint, const Body& a, const Body& b) : joint_(joint), a_(a), b_(b) {
    s_ = across_all([this](const Quat& turn) { return gradient(Quat::Identity(), turn); });
    u_ = across_all([this](const Quat& turn) { return gradient(turn, Quat::Identity()); });
    // Known but for the signs: both reversed are the same cone, and one alone would reverse the gradient.
    Real most = 0;
    bool reversed = false;
    for (const Quat& turn : turns()) {
      const Real along = s_.cross(turn * u_).dot(gradient(Quat::Identity(), turn));
      if (std::abs(along) <= std::abs(most)) continue;
      most = along;
      reversed = along < 0;
    }
    if (reversed) u_ = -u_;
  }
  JointShape operator()() const {
    const Real now = std::acos(std::clamp(s_.dot(u_), Real(-1), Real(1)));
    return {
        .kind = JointShape::cone_limit, .axis = s_, .axis_b = u_, .high = left_of(asked(joint_, a_, b_).front()) + now};
  }

 private:
  static std::array<Quat, 3> turns() {
    std::array<Quat, 3> about;
    for (int axis = 0; axis < 3; ++axis) about[axis] = Eigen::AngleAxis<Real>(Real(0.7), Vec3::Unit(axis));
    return about;
  }
  Vec3 gradient(const Quat& turn_a, const Quat& turn_b) const {
    Body a = a_, b = b_;
    a.orientation = turn_a * a.orientation;
    b.orientation = turn_b * b.orientation;
    return -asked(joint_, a, b).front().jacobian.rb_n;  // the row is that of what is left
  }
  /// What is across all of `of(turn)`: by the two that differ most.
  template <class Of>
  static Vec3 across_all(const Of& of) {
    Vec3 best = Vec3::Zero();
    const auto about = turns();
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 across = of(about[i]).cross(of(about[(i + 1) % 3]));
      if (across.norm() > best.norm()) best = across;
    }
    return best.normalized();
  }

  const Joint& joint_;
  const Body &a_, &b_;
  Vec3 s_, u_;
};

/// One at a speed asks for the same wherever its bodies are.
bool goes_to_an_angle(const Joint& joint, const Body& a, const Body& b, const Vec3& axis) {
  Body turned = b;
  turned.turned(Real(0.1), axis);
  return asked(joint, a, turned).front().error != asked(joint, a, b).front().error;
}

}  // namespace

JointShape shape_of(const World& world, const Joint& joint) {
  const Body &a = world.body(joint.a), &b = world.body(joint.b);
  const Equations equations = asked(joint, a, b);
  if (joint.name == "a ball and socket" || joint.name == "a hinge") {
    const Jacobian &x = equations[0].jacobian, &y = equations[1].jacobian, &z = equations[2].jacobian;
    JointShape shape{.kind = JointShape::ball_and_socket,
                     .anchor_a = a.position + arm_of(x.ra_n, y.ra_n, z.ra_n),
                     .anchor_b = b.position + arm_of(x.rb_n, y.rb_n, z.rb_n)};
    if (joint.name == "a ball and socket") return shape;
    shape.kind = JointShape::hinge;  // held about two directions across its axis
    shape.axis = equations[3].jacobian.rb_n.cross(equations[4].jacobian.rb_n).normalized();
    return shape;
  }
  if (joint.name == "angle limits" || joint.name == "twist limits")
    return {.kind = joint.name == "angle limits" ? JointShape::angle_limits : JointShape::twist_limits,
            .axis = equations[0].jacobian.rb_n.normalized(),
            .low = -left_of(equations[0]),
            .high = left_of(equations[1])};
  if (joint.name == "a cone limit") return Cone(joint, a, b)();
  if (joint.name == "a motor") {
    const Equation& turning = equations[0];
    const Vec3 axis = turning.jacobian.rb_n.normalized();
    if (goes_to_an_angle(joint, a, b, axis)) throw not_had("a motor to an angle");
    return {.kind = JointShape::motor, .axis = axis, .speed = -turning.bias, .torque = turning.hi};
  }
  throw not_had(joint.name);
}

std::vector<HeldPair> held_pairs(const World& world, std::initializer_list<JointShape::Kind> had) {
  std::vector<HeldPair> pairs;
  for (const Joint& joint : world.joints) {
    const JointShape shape = shape_of(world, joint);
    if (std::find(had.begin(), had.end(), shape.kind) == had.end()) throw not_had(joint.name);
    if (shape.kind == JointShape::ball_and_socket || shape.kind == JointShape::hinge) {
      pairs.push_back({.joint = &joint, .shape = shape});
      continue;
    }
    const bool of_hinge = shape.kind == JointShape::angle_limits || shape.kind == JointShape::motor;
    const auto pair = std::find_if(pairs.begin(), pairs.end(), [&](const HeldPair& one) {
      return one.joint->a == joint.a && one.joint->b == joint.b && (one.shape.kind == JointShape::hinge) == of_hinge;
    });
    if (pair == pairs.end()) throw not_had(joint.name + " without the joint that they limit");
    (shape.kind == JointShape::cone_limit ? pair->cone
     : shape.kind == JointShape::motor    ? pair->motor
                                          : pair->turn) = shape;
  }
  return pairs;
}

JointShape turned_to(JointShape shape, const Vec3& axis) {
  if (shape.axis.dot(axis) > 0) return shape;
  shape.axis = -shape.axis;
  shape.speed = -shape.speed;
  shape.low = -std::exchange(shape.high, -shape.low);
  return shape;
}

}  // namespace pushback
