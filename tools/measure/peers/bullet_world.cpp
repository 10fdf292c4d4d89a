/// Bullet 3 moves a world, in float or in double.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "pushback/tools/measure/peers/bullet.h"
#include "pushback/tools/measure/peers/engine.h"
#include "pushback/tools/measure/peers/joint_shape.h"

namespace pushback {

namespace {

Vec3 ours(const btVector3& v) {
  return {static_cast<Real>(v.x()), static_cast<Real>(v.y()), static_cast<Real>(v.z())};
}

// A pair has the product of its two, unless one asks for something else.
btScalar mean_friction(const btCollisionObject* a, const btCollisionObject* b) {
  return std::sqrt(a->getFriction() * b->getFriction());
}
btScalar larger_restitution(const btCollisionObject* a, const btCollisionObject* b) {
  return std::max(a->getRestitution(), b->getRestitution());
}

constexpr btScalar no_limit = 100;  // rad

class Bullet : public Engine {
 public:
  Bullet(const World& world, const PeerSetting& setting) : tuned_(setting.tuned) {
    gCalculateCombinedFrictionCallback = mean_friction;
    gCalculateCombinedRestitutionCallback = larger_restitution;
    dynamics_.emplace(&dispatcher_, &broad_phase_, &solver_, &configuration_);
    dynamics_->setGravity(bullet(world.gravity));
    btContactSolverInfo& info = dynamics_->getSolverInfo();
    info.m_numIterations = setting.sweeps;
    if (tuned_) {
      info.m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;
      info.m_restitutionVelocityThreshold = 0;
      info.m_splitImpulsePenetrationThreshold = 0;
      info.m_warmstartingFactor = 1;
      info.m_erp = btScalar(0.8);
    }
    slab_.half = 50;
    slab_.used = std::any_of(world.bodies.begin(), world.bodies.end(),
                             [](const Body& body) { return std::holds_alternative<Box>(body.shape); });
    for (const Body& body : world.bodies) add(body);
    for (const Joint& joint : world.joints) add(shape_of(world, joint), joint);
  }
  ~Bullet() override {
    for (const auto& joint : joints_) dynamics_->removeConstraint(joint.get());
    for (const auto& body : bodies_) dynamics_->removeRigidBody(body.get());
  }

  void put(const Body& body) override {
    btRigidBody& made = its(body);
    made.setCenterOfMassTransform(slab_.transform_of(body));
    made.setInterpolationWorldTransform(made.getCenterOfMassTransform());
    made.setLinearVelocity(bullet(body.velocity));
    made.setAngularVelocity(bullet(body.angular_velocity));
  }
  void get(Body& body) const override {
    const btRigidBody& made = *bodies_[static_cast<std::size_t>(body.index)];
    const btQuaternion q = made.getOrientation();
    body.position = ours(made.getCenterOfMassPosition());
    body.orientation = Quat(q.w(), q.x(), q.y(), q.z()).normalized();
    body.velocity = ours(made.getLinearVelocity());
    body.angular_velocity = ours(made.getAngularVelocity());
  }
  /// A step makes the velocity of what it finds moved, and leaves it there.
  void drive(const Body&, const Body& then) override { its(then).setWorldTransform(slab_.transform_of(then)); }
  void step(const std::vector<Body>& bodies, Real h) override {
    for (const Body& body : bodies) {
      if (!body.movable()) continue;
      its(body).applyCentralForce(bullet(body.force));
      its(body).applyTorque(bullet(body.torque));
    }
    for (const Motor& motor : motors_) motor.hinge->setMaxMotorImpulse(static_cast<btScalar>(motor.torque * h));
    dynamics_->stepSimulation(static_cast<btScalar>(h), 0);
  }

 private:
  btRigidBody& its(const Body& body) { return its(body.index); }
  btRigidBody& its(int index) {
    return index == the_world ? btTypedConstraint::getFixedBody() : *bodies_[static_cast<std::size_t>(index)];
  }

  void add(const Body& body) {
    shapes_.push_back(slab_.shape_of(body));
    if (tuned_ && std::holds_alternative<Hull>(body.shape)) shapes_.back()->setMargin(btScalar(1e-4));
    btRigidBody::btRigidBodyConstructionInfo info = mass_of(body, shapes_.back().get());
    info.m_startWorldTransform = slab_.transform_of(body);
    info.m_friction = static_cast<btScalar>(body.friction);
    info.m_restitution = static_cast<btScalar>(body.restitution);
    bodies_.push_back(std::make_unique<btRigidBody>(info));
    btRigidBody& made = *bodies_.back();
    if (is_driven(body)) made.setCollisionFlags(made.getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
    made.setLinearVelocity(bullet(body.velocity));
    made.setAngularVelocity(bullet(body.angular_velocity));
    made.setActivationState(DISABLE_DEACTIVATION);
    // From where bodies touch, not from 20 mm before: a gap that is left takes from a bounce.
    if (tuned_ && body.restitution > 0) made.setContactProcessingThreshold(0);
    dynamics_->addRigidBody(&made);
  }

  /// The frame in the body's that now has its axis `which` along `axis`, and its origin at `at`.
  btTransform frame_on(int index, const Vec3& at, int which, const Vec3& axis) {
    const btTransform there(bullet(Quat::FromTwoVectors(Vec3::Unit(which), axis)), bullet(at));
    return its(index).getCenterOfMassTransform().inverse() * there;
  }

  void add(const JointShape& shape, const Joint& joint) {
    btRigidBody &a = its(joint.a), &b = its(joint.b);
    const auto local = [](const btRigidBody& body, const Vec3& at) {
      return body.getCenterOfMassTransform().inverse() * bullet(at);
    };
    switch (shape.kind) {
      case JointShape::ball_and_socket:
        return add(std::make_unique<btPoint2PointConstraint>(a, b, local(a, shape.anchor_a), local(b, shape.anchor_b)),
                   joint);
      case JointShape::hinge:
        return add(std::make_unique<btHingeConstraint>(a, b, frame_on(joint.a, shape.anchor_a, 2, shape.axis),
                                                       frame_on(joint.b, shape.anchor_b, 2, shape.axis), true),
                   joint);
      case JointShape::angle_limits:
        return limit(shape, joint);
      case JointShape::twist_limits:
        if (std::abs(shape.low + shape.high) > Real(1e-4)) throw not_had("twist limits that are not symmetric");
        return add_turns(shape, joint, no_limit, static_cast<btScalar>(shape.high));
      case JointShape::cone_limit:
        return add_turns(shape, joint, static_cast<btScalar>(shape.high), no_limit);
      case JointShape::motor:
        return drive(shape, joint);
    }
  }
  void add(std::unique_ptr<btTypedConstraint> made, const Joint& joint) {
    dynamics_->addConstraint(made.get(), !joint.colliding);
    joints_.push_back(std::move(made));
    pairs_.emplace_back(joint.a, joint.b);
  }
  /// The joint of this kind that the two have.
  template <class Made>
  Made& made_for(const Joint& joint) {
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      auto* made = dynamic_cast<Made*>(joints_[i].get());
      if (made != nullptr && pairs_[i] == std::pair(joint.a, joint.b)) return *made;
    }
    throw not_had(joint.name + " without the joint that they limit");
  }
  bool along(const btHingeConstraint& hinge, const JointShape& shape, const Joint& joint) {
    const btVector3 axis =
        its(joint.a).getCenterOfMassTransform().getBasis() * hinge.getAFrame().getBasis().getColumn(2);
    return axis.dot(bullet(shape.axis)) > 0;
  }
  /// Bullet bounds the impulse of a step: set in each.
  void drive(const JointShape& shape, const Joint& joint) {
    auto& hinge = made_for<btHingeConstraint>(joint);
    hinge.enableAngularMotor(true, static_cast<btScalar>(along(hinge, shape, joint) ? shape.speed : -shape.speed), 0);
    motors_.push_back({&hinge, shape.torque});
  }
  void limit(const JointShape& shape, const Joint& joint) {
    auto& hinge = made_for<btHingeConstraint>(joint);
    const bool along = this->along(hinge, shape, joint);
    hinge.setLimit(static_cast<btScalar>(along ? shape.low : -shape.high),
                   static_cast<btScalar>(along ? shape.high : -shape.low), 1);
  }
  /// The cone of the swing, or the twist. Bullet's joint with both holds two points on each other, too: those of the ball and socket.
  void add_turns(const JointShape& shape, const Joint& joint, btScalar swing, btScalar twist) {
    const auto& socket = made_for<btPoint2PointConstraint>(joint);
    const Vec3& axis_b = shape.kind == JointShape::cone_limit ? shape.axis_b : shape.axis;
    btTransform on_a = frame_on(joint.a, Vec3::Zero(), 0, shape.axis),
                on_b = frame_on(joint.b, Vec3::Zero(), 0, axis_b);
    on_a.setOrigin(socket.getPivotInA());
    on_b.setOrigin(socket.getPivotInB());
    auto made = std::make_unique<btConeTwistConstraint>(its(joint.a), its(joint.b), on_a, on_b);
    made->setLimit(swing, swing, twist, 1);
    add(std::move(made), joint);
  }

  struct Motor {
    btHingeConstraint* hinge;
    Real torque;  // N m
  };

  bool tuned_;
  Slab slab_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broad_phase_;
  btSequentialImpulseConstraintSolver solver_;
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
  std::vector<std::unique_ptr<btTypedConstraint>> joints_;
  std::vector<std::pair<int, int>> pairs_;  // of each joint
  std::vector<Motor> motors_;
  std::optional<btDiscreteDynamicsWorld> dynamics_;
};

}  // namespace

std::unique_ptr<Engine> begin_engine(const World& world, const PeerSetting& setting) {
  return std::make_unique<Bullet>(world, setting);
}

}  // namespace pushback
