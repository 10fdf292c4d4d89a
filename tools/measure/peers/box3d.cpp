/// Box3D, in float.
#include <box3d/box3d.h>
#include <fmt/format.h>

#include <cmath>

#include "pushback/tools/measure/peers/peer.h"

namespace pushback {

namespace {

/// What its settings differ in. As it comes: none of these.
struct Box3dChoice {
  /// Contacts and joints as stiff as Box3D allows for a substep of h: 1/(8 h) and 1/(4 h) Hz, in the place of 30 and 60 Hz. What
  /// bounces does so at any speed, not from 1 m/s on. Bodies may have 10 km/s, not 400 m/s, and turn by any angle in a step, not 45
  /// degrees.
  bool stiff = false;
  /// Manifolds are made in each step, not kept until two bodies have moved by 5 cm or 10 degrees against each other.
  bool anew = false;
  /// Bodies that begin faster than the smallest side of the box around them in 1/60 s are cast along their way against others that move,
  /// not only against those that stand. Two such bodies are not cast against each other, so not all are.
  bool bullets = false;
};

constexpr float half_slab = 50;  // m

/// Asked for where Box3D takes no more than a substep allows: it clamps to that by itself.
constexpr float any_hertz = 1e6F;

float real(Real value) {
  return static_cast<float>(value);
}
b3Vec3 vector(const Vec3& v) {
  return {real(v.x()), real(v.y()), real(v.z())};
}
b3Quat turn(const Quat& q) {
  return {{real(q.x()), real(q.y()), real(q.z())}, real(q.w())};
}
Vec3 ours(const b3Vec3& v) {
  return {static_cast<Real>(v.x), static_cast<Real>(v.y), static_cast<Real>(v.z)};
}

/// What stands at `at` and is turned by `orientation`, both in world axes, in the axes of the body.
b3Transform frame_in(const Body& body, const Vec3& at, const Quat& orientation) {
  const Quat back = body.orientation.conjugate();
  return {vector(back * (at - body.position)), turn((back * orientation).normalized())};
}

class Box3d : public Engine {
 public:
  /// Each step is divided into `substeps`: contacts are detected once for all of them.
  Box3d(const World& world, const Box3dChoice& choice, int substeps) : choice_(choice), substeps_(substeps) {
    b3WorldDef description = b3DefaultWorldDef();  // of a pair: the geometric mean of frictions, the larger restitution
    description.gravity = vector(world.gravity);
    description.enableSleep = false;
    if (choice.stiff) {
      description.contactHertz = any_hertz;
      description.restitutionThreshold = 0;
      description.maximumLinearSpeed = 1e4F;
    }
    world_ = b3CreateWorld(&description);
    if (choice.anew) b3World_SetContactRecycleDistance(world_, 0);
    for (const Body& body : world.bodies) add(body);
    const b3BodyDef still = b3DefaultBodyDef();
    last_ = static_cast<int>(bodies_.size());
    bodies_.push_back(b3CreateBody(world_, &still));
    for (const HeldPair& pair : held_pairs(world)) add(world, pair);
  }

  ~Box3d() override { b3DestroyWorld(world_); }
  Box3d(const Box3d&) = delete;
  Box3d& operator=(const Box3d&) = delete;

  void put(const Body& body) override {
    const b3BodyId made = its(body.index);
    b3Body_SetTransform(made, vector(body.position), turn(body.orientation));
    if (b3Body_GetType(made) == b3_staticBody) return;
    b3Body_SetLinearVelocity(made, vector(body.velocity));
    b3Body_SetAngularVelocity(made, vector(body.angular_velocity));
  }

  void get(Body& body) const override {
    const b3BodyId made = its(body.index);
    const b3Quat q = b3Body_GetRotation(made);
    body.position = ours(b3Body_GetPosition(made));
    body.orientation = Quat(q.s, q.v.x, q.v.y, q.v.z).normalized();
    body.velocity = ours(b3Body_GetLinearVelocity(made));
    body.angular_velocity = ours(b3Body_GetAngularVelocity(made));
  }

  /// A kinematic body moves by its velocity.
  void drive(const Body& now, const Body&) override { put(now); }

  void push(const Body& body) override {
    if (!body.force.isZero(0)) b3Body_ApplyForceToCenter(its(body.index), vector(body.force), true);
    if (!body.torque.isZero(0)) b3Body_ApplyTorque(its(body.index), vector(body.torque), true);
  }
  void step(double h) override { b3World_Step(world_, static_cast<float>(h), substeps_); }

 private:
  b3BodyId its(int index) const { return bodies_[static_cast<std::size_t>(index == the_world ? last_ : index)]; }

  void add(const Body& body) {
    b3BodyDef description = b3DefaultBodyDef();
    description.type = body.movable() ? b3_dynamicBody : is_driven(body) ? b3_kinematicBody : b3_staticBody;
    description.position = vector(body.position);
    description.rotation = turn(body.orientation);
    if (!body.conveys) {
      description.linearVelocity = vector(body.velocity);
      description.angularVelocity = vector(body.angular_velocity);
    }
    description.enableSleep = false;
    description.allowFastRotation = choice_.stiff;
    const b3BodyId made = b3CreateBody(world_, &description);
    add_shape(made, body);
    if (choice_.bullets && body.movable()) {
      const b3AABB box = b3Body_ComputeAABB(made);
      const Real smallest = (ours(box.upperBound) - ours(box.lowerBound)).minCoeff();
      b3Body_SetBullet(made, body.velocity.norm() > 60 * smallest);
    }
    if (body.movable()) {
      const Vec3 inertia = body.principal_inverse_inertia.cwiseInverse();
      b3MassData mass{.mass = real(1 / body.inverse_mass), .center = b3Vec3_zero, .inertia = b3Mat3_zero};
      mass.inertia.cx.x = real(inertia.x());
      mass.inertia.cy.y = real(inertia.y());
      mass.inertia.cz.z = real(inertia.z());
      b3Body_SetMassData(made, mass);
    }
    bodies_.push_back(made);
  }

  /// Box3D has no plane: a half-space is a slab of 100 m, as in its own samples.
  void add_shape(b3BodyId made, const Body& body) const {
    b3ShapeDef description = b3DefaultShapeDef();
    description.baseMaterial.friction = real(body.friction);
    description.baseMaterial.restitution = real(body.restitution);
    if (body.conveys) description.baseMaterial.tangentVelocity = vector(body.orientation.conjugate() * body.velocity);
    if (const auto* ball = std::get_if<Sphere>(&body.shape)) {
      const b3Sphere sphere{b3Vec3_zero, real(ball->radius)};
      b3CreateSphereShape(made, &description, &sphere);
    } else if (const auto* box = std::get_if<Box>(&body.shape)) {
      const b3Vec3 half = vector(box->half_extents);
      const b3BoxHull hull = b3MakeBoxHull(half.x, half.y, half.z);
      b3CreateHullShape(made, &description, &hull.base);
    } else if (const auto* capsule = std::get_if<Capsule>(&body.shape)) {
      const float half = real(capsule->half_length);
      const b3Capsule along_y{{0, -half, 0}, {0, half, 0}, real(capsule->radius)};
      b3CreateCapsuleShape(made, &description, &along_y);
    } else if (const auto* solid = std::get_if<Hull>(&body.shape)) {
      std::vector<b3Vec3> corners;
      for (const Vec3& corner : solid->solid->corners) corners.push_back(vector(corner));
      const int count = static_cast<int>(corners.size());
      b3HullData* hull = b3CreateHull(corners.data(), count, count);
      if (hull == nullptr) throw not_had(fmt::format("a hull of {} corners", count));
      b3CreateHullShape(made, &description, hull);  // which copies it
      b3DestroyHull(hull);
    } else {
      const Vec3 normal = body.orientation.conjugate() * std::get<HalfSpace>(body.shape).normal;
      const b3Transform below{vector(-static_cast<Real>(half_slab) * normal),
                              turn(Quat::FromTwoVectors(Vec3::UnitY(), normal))};
      const b3BoxHull slab = b3MakeTransformedBoxHull(half_slab, half_slab, half_slab, below);
      b3CreateHullShape(made, &description, &slab.base);
    }
  }

  void add(const World& world, const HeldPair& pair) {
    const Joint& joint = *pair.joint;
    const JointShape& shape = pair.shape;
    const bool hinge = shape.kind == JointShape::hinge;
    const Quat axes = hinge ? Quat::FromTwoVectors(Vec3::UnitZ(), shape.axis) : Quat::Identity();
    const auto fill = [&](b3JointDef& base) {
      base.bodyIdA = its(joint.a);
      base.bodyIdB = its(joint.b);
      base.localFrameA = frame_in(world.body(joint.a), shape.anchor_a, axes);
      base.localFrameB = frame_in(world.body(joint.b), shape.anchor_b, axes);
      base.collideConnected = joint.colliding;
      if (choice_.stiff) base.constraintHertz = any_hertz;
    };
    if (hinge) {
      b3RevoluteJointDef description = b3DefaultRevoluteJointDef();
      fill(description.base);
      limit_hinge(b3CreateRevoluteJoint(world_, &description), pair);
    } else {
      b3SphericalJointDef description = b3DefaultSphericalJointDef();
      fill(description.base);
      limit_socket(b3CreateSphericalJoint(world_, &description), world, pair);
    }
  }

  static void limit_hinge(b3JointId hinge, const HeldPair& pair) {
    if (pair.turn) {
      const JointShape turn = turned_to(*pair.turn, pair.shape.axis);
      b3RevoluteJoint_SetLimits(hinge, real(turn.low), real(turn.high));
      b3RevoluteJoint_EnableLimit(hinge, true);
    }
    if (pair.motor) {
      b3RevoluteJoint_SetMotorSpeed(hinge, real(turned_to(*pair.motor, pair.shape.axis).speed));
      b3RevoluteJoint_SetMaxMotorTorque(hinge, real(pair.motor->torque));
      b3RevoluteJoint_EnableMotor(hinge, true);
    }
  }

  /// The cone is about the z axis of A's frame, the twist about that of B's.
  static void limit_socket(b3JointId socket, const World& world, const HeldPair& pair) {
    if (!pair.cone && !pair.turn) return;
    const Vec3 axis_a = pair.cone ? pair.cone->axis : pair.turn->axis;
    const Vec3 axis_b = pair.cone ? pair.cone->axis_b : pair.turn->axis;
    const Quat on_a = Quat::FromTwoVectors(Vec3::UnitZ(), axis_a), on_b = Quat::FromTwoVectors(axis_a, axis_b) * on_a;
    b3Joint_SetLocalFrameA(socket, frame_in(world.body(pair.joint->a), pair.shape.anchor_a, on_a));
    b3Joint_SetLocalFrameB(socket, frame_in(world.body(pair.joint->b), pair.shape.anchor_b, on_b));
    if (pair.cone) {
      b3SphericalJoint_SetConeLimit(socket, real(pair.cone->high));
      b3SphericalJoint_EnableConeLimit(socket, true);
    }
    if (!pair.turn) return;
    if (std::abs(axis_b.dot(pair.turn->axis)) < Real(0.9999))
      throw not_had("twist limits about another axis than the cone's");
    const JointShape twist = turned_to(*pair.turn, axis_b);
    b3SphericalJoint_SetTwistLimits(socket, real(twist.low), real(twist.high));
    b3SphericalJoint_EnableTwistLimit(socket, true);
  }

  Box3dChoice choice_;
  int substeps_;
  b3WorldId world_;
  std::vector<b3BodyId> bodies_;  // those of the world, and one that stands for the world
  int last_ = 0;
};

/// `often`: substeps are steps of Box3D's, each with so many substeps of its own as there are sweeps. Else a frame is a step.
Method method(const std::string& name, const std::string& title, const Box3dChoice& choice, bool often = false) {
  return {.name = name,
          .title = title,
          .begin =
              [choice, often](const World& world, const Setting& setting) {
                return std::make_unique<Box3d>(world, choice, often ? setting.sweeps : setting.substeps);
              },
          .sweeps = often,
          .divides = !often};
}

}  // namespace

std::vector<Method> peer_methods() {
  return {method("box3d", "Box3D", {}), method("box3d-stiff", "Box3D, stiff", {.stiff = true}),
          method("box3d-often", "Box3D, stiff, contacts detected in each substep", {.stiff = true}, true),
          method("box3d-manifolds-anew", "Box3D, stiff, manifolds made in each step", {.stiff = true, .anew = true})};
}

std::unique_ptr<Engine> begin_engine(const World& world, const PeerSetting& setting) {
  return std::make_unique<Box3d>(
      world, Box3dChoice{.stiff = setting.tuned, .anew = setting.has("anew"), .bullets = setting.has("bullets")},
      setting.own_substeps);
}

std::string peer_version() {
  const b3Version version = b3GetVersion();
  return fmt::format("Box3D {}.{}.{}, float, {}; called by {}", version.major, version.minor, version.revision,
                     PUSHBACK_ENGINE_IS, built_by());
}

}  // namespace pushback
