/// Jolt, in float, here on one thread.
// Theirs begins with this one.
#include <Jolt/Jolt.h>
//
#include <Jolt/ConfigurationString.h>
#include <Jolt/Core/Factory.h>
#include <Jolt/Core/JobSystemSingleThreaded.h>
#include <Jolt/Core/TempAllocator.h>
#include <Jolt/Physics/Body/Body.h>
#include <Jolt/Physics/Body/BodyCreationSettings.h>
#include <Jolt/Physics/Collision/BroadPhase/BroadPhaseLayerInterfaceTable.h>
#include <Jolt/Physics/Collision/BroadPhase/ObjectVsBroadPhaseLayerFilterTable.h>
#include <Jolt/Physics/Collision/ContactListener.h>
#include <Jolt/Physics/Collision/GroupFilterTable.h>
#include <Jolt/Physics/Collision/ObjectLayerPairFilterTable.h>
#include <Jolt/Physics/Collision/Shape/BoxShape.h>
#include <Jolt/Physics/Collision/Shape/CapsuleShape.h>
#include <Jolt/Physics/Collision/Shape/ConvexHullShape.h>
#include <Jolt/Physics/Collision/Shape/PlaneShape.h>
#include <Jolt/Physics/Collision/Shape/SphereShape.h>
#include <Jolt/Physics/Constraints/HingeConstraint.h>
#include <Jolt/Physics/Constraints/PointConstraint.h>
#include <Jolt/Physics/Constraints/SwingTwistConstraint.h>
#include <Jolt/Physics/PhysicsSystem.h>
#include <Jolt/RegisterTypes.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "pushback/common/basics/input.h"
#include "pushback/tools/measure/peers/peer.h"

namespace pushback {

namespace {

/// What its settings differ in.
struct JoltChoice {
  /// Bounces at any speed, no overlap that is let be, no rounding of corners, a gyroscopic torque, and as many velocity sweeps
  /// as are asked, a quarter as many of positions. Else as it comes: 10 and 2; it bounces from 1 m/s on, leaves 20 mm, and
  /// rounds by 50 mm.
  bool tuned = false;
  int sweeps = 10;
  /// What would pass through another body in a step is stopped at it, as for its documentation's small and fast bodies.
  bool cast = false;
  /// Contacts act from 1 mm before bodies touch, not from 20 mm.
  bool close = false;
};

constexpr JPH::ObjectLayer resting = 0, moving = 1;
constexpr float rounding_as_it_comes = 0.05F;  // m
constexpr float most_speed = 1e4F;             // m/s and rad/s

float real(Real value) {
  return static_cast<float>(value);
}
JPH::Vec3 vector(const Vec3& v) {
  return {real(v.x()), real(v.y()), real(v.z())};
}
JPH::Quat turn(const Quat& q) {
  return JPH::Quat(real(q.x()), real(q.y()), real(q.z()), real(q.w())).Normalized();
}
Vec3 ours(const JPH::Vec3& v) {
  return {static_cast<Real>(v.GetX()), static_cast<Real>(v.GetY()), static_cast<Real>(v.GetZ())};
}

template <class Settings>
JPH::RefConst<JPH::Shape> made(const Settings& settings, const char* what) {
  const JPH::ShapeSettings::ShapeResult result = settings.Create();
  if (result.HasError()) throw not_had(fmt::format("{}: {}", what, result.GetError().c_str()));
  return result.Get();
}

/// Once in a program, before anything else of Jolt's.
void start_jolt() {
  static const bool ready = [] {
    JPH::RegisterDefaultAllocator();
    JPH::Factory::sInstance = new JPH::Factory;  // for as long as the program runs
    JPH::RegisterTypes();
    return true;
  }();
  static_cast<void>(ready);
}

/// Contacts of surfaces that convey.
class Belts : public JPH::ContactListener {
 public:
  /// m/s, world axes; 0 where no surface of the body conveys.
  std::vector<JPH::Vec3> speeds;  // in the order of Body::GetUserData

  void OnContactAdded(const JPH::Body& one, const JPH::Body& other, const JPH::ContactManifold&,
                      JPH::ContactSettings& settings) override {
    settings.mRelativeLinearSurfaceVelocity = speeds[other.GetUserData()] - speeds[one.GetUserData()];
  }
  void OnContactPersisted(const JPH::Body& one, const JPH::Body& other, const JPH::ContactManifold& manifold,
                          JPH::ContactSettings& settings) override {
    OnContactAdded(one, other, manifold, settings);
  }
};

class Jolt : public Engine {
 public:
  Jolt(const World& world, const JoltChoice& choice) : choice_(choice) {
    pairs_.EnableCollision(resting, moving);
    pairs_.EnableCollision(moving, moving);
    for (const JPH::ObjectLayer layer : {resting, moving})
      layers_.MapObjectToBroadPhaseLayer(layer, JPH::BroadPhaseLayer(static_cast<JPH::BroadPhaseLayer::Type>(layer)));
    layer_pairs_.emplace(layers_, 2, pairs_, 2);
    const auto count = static_cast<JPH::uint>(world.bodies.size()), many = 64 + 32 * count;
    system_.Init(count + 2, 0, many, many, layers_, *layer_pairs_, pairs_);
    system_.SetGravity(vector(world.gravity));
    JPH::PhysicsSettings settings = system_.GetPhysicsSettings();
    settings.mAllowSleeping = false;
    if (choice.tuned) {
      settings.mNumVelocitySteps = static_cast<JPH::uint>(choice.sweeps);
      settings.mNumPositionSteps = static_cast<JPH::uint>(std::max(1, choice.sweeps / 4));
      settings.mPenetrationSlop = 0;
      settings.mMinVelocityForRestitution = 0;
    }
    if (choice.close) settings.mSpeculativeContactDistance = 0.001F;
    system_.SetPhysicsSettings(settings);
    unjoined_ = new JPH::GroupFilterTable(count);
    for (const Body& body : world.bodies) {
      add(body);
      belts_.speeds.push_back(body.conveys ? vector(body.velocity) : JPH::Vec3::sZero());
      if (body.conveys) system_.SetContactListener(&belts_);
    }
    for (const HeldPair& pair : held_pairs(world)) add(pair);
  }

  ~Jolt() override {
    for (const JPH::Ref<JPH::Constraint>& constraint : system_.GetConstraints()) system_.RemoveConstraint(constraint);
    for (const JPH::Body* body : bodies_) {
      system_.GetBodyInterfaceNoLock().RemoveBody(body->GetID());
      system_.GetBodyInterfaceNoLock().DestroyBody(body->GetID());
    }
  }

  Jolt(const Jolt&) = delete;
  Jolt& operator=(const Jolt&) = delete;

  void put(const Body& body) override {
    JPH::Body& made = its(body.index);
    system_.GetBodyInterfaceNoLock().SetPositionAndRotation(made.GetID(), vector(body.position), turn(body.orientation),
                                                            JPH::EActivation::Activate);
    if (made.IsStatic()) return;
    made.SetLinearVelocity(vector(body.velocity));
    made.SetAngularVelocity(vector(body.angular_velocity));
  }

  void get(Body& body) const override {
    const JPH::Body& made = its(body.index);
    const JPH::Quat q = made.GetRotation();
    body.position = ours(made.GetCenterOfMassPosition());
    body.orientation = Quat(q.GetW(), q.GetX(), q.GetY(), q.GetZ()).normalized();
    body.velocity = ours(made.GetLinearVelocity());
    body.angular_velocity = ours(made.GetAngularVelocity());
  }

  /// A kinematic body moves by its velocity.
  void drive(const Body& now, const Body&) override { put(now); }

  void push(const Body& body) override {
    its(body.index).AddForce(vector(body.force));
    its(body.index).AddTorque(vector(body.torque));
  }
  void step(double h) override {
    if (system_.Update(static_cast<float>(h), 1, &memory_, &jobs_) != JPH::EPhysicsUpdateError::None)
      throw InvalidInput("Jolt has no room for so many contacts");
  }

 private:
  JPH::Body& its(int index) const {
    return index == the_world ? JPH::Body::sFixedToWorld : *bodies_[static_cast<std::size_t>(index)];
  }

  JPH::RefConst<JPH::Shape> shape_of(const Body& body) const {
    const float rounding = choice_.tuned ? 0 : rounding_as_it_comes;
    if (const auto* ball = std::get_if<Sphere>(&body.shape))
      return made(JPH::SphereShapeSettings(real(ball->radius)), "a ball");
    if (const auto* box = std::get_if<Box>(&body.shape)) {
      const JPH::Vec3 half = vector(box->half_extents);
      return made(JPH::BoxShapeSettings(half, std::min(rounding, half.ReduceMin())), "a box");
    }
    if (const auto* capsule = std::get_if<Capsule>(&body.shape))
      return made(JPH::CapsuleShapeSettings(real(capsule->half_length), real(capsule->radius)), "a capsule");
    if (const auto* solid = std::get_if<Hull>(&body.shape)) {
      JPH::Array<JPH::Vec3> corners;
      for (const Vec3& corner : solid->solid->corners) corners.push_back(vector(corner));
      return made(JPH::ConvexHullShapeSettings(corners, rounding), "a hull");
    }
    const Vec3 normal = body.orientation.conjugate() * std::get<HalfSpace>(body.shape).normal;
    return made(JPH::PlaneShapeSettings(JPH::Plane(vector(normal), 0)), "a plane");
  }

  void add(const Body& body) {
    const JPH::EMotionType type = body.movable()    ? JPH::EMotionType::Dynamic
                                  : is_driven(body) ? JPH::EMotionType::Kinematic
                                                    : JPH::EMotionType::Static;
    JPH::BodyCreationSettings settings(shape_of(body), vector(body.position), turn(body.orientation), type,
                                       type == JPH::EMotionType::Static ? resting : moving);
    settings.mFriction = real(body.friction);  // of a pair: the geometric mean, and the larger restitution
    settings.mRestitution = real(body.restitution);
    settings.mLinearDamping = settings.mAngularDamping = 0;
    settings.mMaxLinearVelocity = settings.mMaxAngularVelocity = most_speed;
    settings.mAllowSleeping = false;
    settings.mApplyGyroscopicForce = choice_.tuned;
    if (choice_.cast) settings.mMotionQuality = JPH::EMotionQuality::LinearCast;
    settings.mUserData = static_cast<JPH::uint64>(body.index);
    settings.mCollisionGroup =
        JPH::CollisionGroup(unjoined_, 0, static_cast<JPH::CollisionGroup::SubGroupID>(body.index));
    if (body.movable()) {
      settings.mOverrideMassProperties = JPH::EOverrideMassProperties::MassAndInertiaProvided;
      settings.mMassPropertiesOverride.mMass = real(1 / body.inverse_mass);
      settings.mMassPropertiesOverride.mInertia =
          JPH::Mat44::sScale(vector(body.principal_inverse_inertia.cwiseInverse()));
    }
    JPH::Body* made = system_.GetBodyInterfaceNoLock().CreateBody(settings);
    system_.GetBodyInterfaceNoLock().AddBody(made->GetID(), JPH::EActivation::Activate);
    if (type != JPH::EMotionType::Static) {
      made->SetLinearVelocity(vector(body.velocity));
      made->SetAngularVelocity(vector(body.angular_velocity));
    }
    bodies_.push_back(made);
  }

  /// A joint with its limits and its motor is a single constraint of Jolt's.
  void add(const HeldPair& asked) {
    const Joint& joint = *asked.joint;
    if (joint.a != the_world && joint.b != the_world && !joint.colliding)
      unjoined_->DisableCollision(static_cast<JPH::CollisionGroup::SubGroupID>(joint.a),
                                  static_cast<JPH::CollisionGroup::SubGroupID>(joint.b));
    JPH::Body &a = its(joint.a), &b = its(joint.b);
    if (asked.shape.kind == JointShape::hinge) {
      JPH::HingeConstraintSettings settings;
      settings.mPoint1 = vector(asked.shape.anchor_a);
      settings.mPoint2 = vector(asked.shape.anchor_b);
      const Vec3 axis = asked.turn ? asked.turn->axis : asked.shape.axis;
      settings.mHingeAxis1 = settings.mHingeAxis2 = vector(axis);
      settings.mNormalAxis1 = settings.mNormalAxis2 = vector(axis.unitOrthogonal());
      if (asked.turn) {
        if (asked.turn->low > 0 || asked.turn->high < 0) throw not_had("angle limits without the angle of the begin");
        settings.mLimitsMin = std::max(real(asked.turn->low), -JPH::JPH_PI);
        settings.mLimitsMax = std::min(real(asked.turn->high), JPH::JPH_PI);
      }
      const JPH::Ref<JPH::TwoBodyConstraint> made = settings.Create(a, b);
      if (asked.motor) {
        auto& hinge = static_cast<JPH::HingeConstraint&>(*made);
        hinge.GetMotorSettings().SetTorqueLimit(real(asked.motor->torque));
        hinge.SetTargetAngularVelocity(real(turned_to(*asked.motor, axis).speed));
        hinge.SetMotorState(JPH::EMotorState::Velocity);
      }
      system_.AddConstraint(made);
    } else if (asked.cone || asked.turn) {
      add_socket_with_limits(asked);
    } else {
      JPH::PointConstraintSettings settings;
      settings.mPoint1 = vector(asked.shape.anchor_a);
      settings.mPoint2 = vector(asked.shape.anchor_b);
      system_.AddConstraint(settings.Create(a, b));
    }
  }

  /// The twist is about the axis of the cone, where there is one.
  void add_socket_with_limits(const HeldPair& asked) {
    const Vec3 axis_a = asked.cone ? asked.cone->axis : asked.turn->axis;
    const Vec3 axis_b = asked.cone ? asked.cone->axis_b : asked.turn->axis;
    const Vec3 across = axis_a.unitOrthogonal();
    JPH::SwingTwistConstraintSettings settings;
    settings.mPosition1 = vector(asked.shape.anchor_a);
    settings.mPosition2 = vector(asked.shape.anchor_b);
    settings.mTwistAxis1 = vector(axis_a);
    settings.mTwistAxis2 = vector(axis_b);
    settings.mPlaneAxis1 = vector(across);
    settings.mPlaneAxis2 = vector(Quat::FromTwoVectors(axis_a, axis_b) * across);
    settings.mNormalHalfConeAngle = settings.mPlaneHalfConeAngle = asked.cone ? real(asked.cone->high) : JPH::JPH_PI;
    settings.mTwistMinAngle = -JPH::JPH_PI;
    settings.mTwistMaxAngle = JPH::JPH_PI;
    if (asked.turn) {
      if (std::abs(axis_b.dot(asked.turn->axis)) < Real(0.9999))
        throw not_had("twist limits about another axis than the cone's");
      const JointShape twist = turned_to(*asked.turn, axis_b);
      settings.mTwistMinAngle = real(twist.low);
      settings.mTwistMaxAngle = real(twist.high);
    }
    system_.AddConstraint(settings.Create(its(asked.joint->a), its(asked.joint->b)));
  }

  JoltChoice choice_;
  JPH::ObjectLayerPairFilterTable pairs_{2};
  JPH::BroadPhaseLayerInterfaceTable layers_{2, 2};
  std::optional<JPH::ObjectVsBroadPhaseLayerFilterTable> layer_pairs_;
  JPH::TempAllocatorImplWithMallocFallback memory_{8 << 20};
  JPH::JobSystemSingleThreaded jobs_{JPH::cMaxPhysicsJobs};
  Belts belts_;
  JPH::PhysicsSystem system_;
  JPH::Ref<JPH::GroupFilterTable> unjoined_;
  std::vector<JPH::Body*> bodies_;
};

Method method(const std::string& name, const std::string& title, const JoltChoice& choice) {
  return {.name = name,
          .title = title,
          .begin =
              [choice](const World& world, const Setting& setting) {
                start_jolt();
                JoltChoice with = choice;
                with.sweeps = setting.sweeps;
                return std::make_unique<Jolt>(world, with);
              },
          .sweeps = choice.tuned};
}

}  // namespace

std::vector<Method> peer_methods() {
  return {method("jolt", "Jolt, as it comes", {}), method("jolt-tuned", "Jolt, tuned", {.tuned = true}),
          method("jolt-close", "Jolt, tuned, contacts from 1 mm on, and a cast along the way",
                 {.tuned = true, .cast = true, .close = true})};
}

std::unique_ptr<Engine> begin_engine(const World& world, const PeerSetting& setting) {
  start_jolt();
  return std::make_unique<Jolt>(world, JoltChoice{.tuned = setting.tuned,
                                                  .sweeps = setting.sweeps,
                                                  .cast = setting.has("cast"),
                                                  .close = setting.has("close")});
}

std::string peer_version() {
  std::string is = JPH::GetConfigurationString();
  is.erase(is.find_last_not_of(' ') + 1);
  return fmt::format("Jolt {}.{}.{}, float, {}, {}; called by {}", JPH_VERSION_MAJOR, JPH_VERSION_MINOR,
                     JPH_VERSION_PATCH, is, PUSHBACK_ENGINE_IS, built_by());
}

}  // namespace pushback
