/// ODE moves a world.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <list>

#include "pushback/common/basics/input.h"
#include "pushback/tools/measure/peers/engine.h"
#include "pushback/tools/measure/peers/joint_shape.h"
#include "pushback/tools/measure/peers/ode.h"

namespace pushback {

namespace {

/// So many contacts at most are solved directly in a step: of more, as in a stack of ten, bodies fly off.
constexpr int most_direct = 16;

class Ode : public Engine {
 public:
  Ode(const World& world, const PeerSetting& setting)
      : tuned_(setting.tuned),
        world_(dWorldCreate()),
        space_(dHashSpaceCreate(nullptr)),
        contacts_(dJointGroupCreate(0)),
        joined_(world.joints) {
    dRandSetSeed(0);  // QuickStep sweeps in random order
    dWorldSetGravity(world_, world.gravity.x(), world.gravity.y(), world.gravity.z());
    dWorldSetQuickStepNumIterations(world_, setting.sweeps);
    if (tuned_) {
      dWorldSetContactMaxCorrectingVel(world_, 3);
      dWorldSetContactSurfaceLayer(world_, 5e-4);
    }
    for (const Body& body : world.bodies) add(body);
    for (const Joint& joint : world.joints) add(shape_of(world, joint), joint);
  }
  ~Ode() override {
    dJointGroupDestroy(contacts_);
    dSpaceDestroy(space_);
    dWorldDestroy(world_);
  }
  Ode(const Ode&) = delete;
  Ode& operator=(const Ode&) = delete;

  void put(const Body& body) override {
    const Made& made = bodies_[static_cast<std::size_t>(body.index)];
    if (made.body != nullptr) put_where(made.body, body);
    else place(made.geom, body);
  }
  void get(Body& body) const override {
    dBodyID made = bodies_[static_cast<std::size_t>(body.index)].body;
    const auto vector = [](const dReal* v) { return Vec3(Eigen::Map<const Eigen::Vector3d>(v).cast<Real>()); };
    const dReal* q = dBodyGetQuaternion(made);
    body.position = vector(dBodyGetPosition(made));
    body.orientation = Quat(q[0], q[1], q[2], q[3]);
    body.velocity = vector(dBodyGetLinearVel(made));
    body.angular_velocity = vector(dBodyGetAngularVel(made));
  }
  /// A kinematic body moves by its velocity.
  void drive(const Body& now, const Body&) override { put(now); }
  void step(const std::vector<Body>& bodies, Real h) override {
    for (const Body& body : bodies) {
      if (!body.movable()) continue;
      dBodyID made = bodies_[static_cast<std::size_t>(body.index)].body;
      dBodyAddForce(made, body.force.x(), body.force.y(), body.force.z());
      dBodyAddTorque(made, body.torque.x(), body.torque.y(), body.torque.z());
    }
    found_ = 0;
    dSpaceCollide(space_, this, [](void* ode, dGeomID a, dGeomID b) { static_cast<Ode*>(ode)->collide(a, b); });
    if (tuned_ && found_ <= most_direct) dWorldStep(world_, h);
    else dWorldQuickStep(world_, h);
    dJointGroupEmpty(contacts_);
  }

 private:
  struct Made {
    dBodyID body;  // null for one that nothing moves
    dGeomID geom;
    double friction, restitution;
  };

  struct Hinge {
    dJointID id;
    int a, b;
    Vec3 axis;
  };

  dBodyID body_of(int index) const {
    return index == the_world ? nullptr : bodies_[static_cast<std::size_t>(index)].body;
  }

  /// ODE's capsule is along z.
  static Quat upright(const Body& body) {
    return std::holds_alternative<Capsule>(body.shape) ? Quat::FromTwoVectors(Vec3::UnitZ(), Vec3::UnitY())
                                                       : Quat::Identity();
  }

  dGeomID geom_of(const Body& body) {
    if (const auto* ball = std::get_if<Sphere>(&body.shape)) return dCreateSphere(space_, ball->radius);
    if (const auto* capsule = std::get_if<Capsule>(&body.shape))
      return dCreateCapsule(space_, capsule->radius, 2 * capsule->half_length);
    if (const auto* hull = std::get_if<Hull>(&body.shape)) return solids_.emplace_back(*hull->solid).made(space_);
    if (const auto* half_space = std::get_if<HalfSpace>(&body.shape)) {
      const Vec3& n = half_space->normal;
      return dCreatePlane(space_, n.x(), n.y(), n.z(), n.dot(body.position));
    }
    const Vec3 lengths = 2 * std::get<Box>(body.shape).half_extents;
    return dCreateBox(space_, lengths.x(), lengths.y(), lengths.z());
  }

  static void place(dGeomID geom, const Body& body) {
    if (const auto* half_space = std::get_if<HalfSpace>(&body.shape)) {
      const Vec3& n = half_space->normal;
      return dGeomPlaneSetParams(geom, n.x(), n.y(), n.z(), n.dot(body.position));
    }
    const Eigen::Quaterniond q = (body.orientation * upright(body)).cast<double>();
    const dQuaternion turn{q.w(), q.x(), q.y(), q.z()};
    dGeomSetPosition(geom, body.position.x(), body.position.y(), body.position.z());
    dGeomSetQuaternion(geom, turn);
  }

  void add(const Body& body) {
    Made made{nullptr, geom_of(body), static_cast<double>(body.friction), static_cast<double>(body.restitution)};
    dGeomSetData(made.geom, reinterpret_cast<void*>(bodies_.size()));
    if (body.movable() || is_driven(body)) {
      made.body = dBodyCreate(world_);
      if (body.movable()) {
        const dMass mass = mass_of(body);
        dBodySetMass(made.body, &mass);
      } else {
        dBodySetKinematic(made.body);
      }
      dGeomSetBody(made.geom, made.body);
      put_where(made.body, body);
      const Eigen::Quaterniond q = upright(body).cast<double>();
      const dQuaternion turn{q.w(), q.x(), q.y(), q.z()};
      if (std::holds_alternative<Capsule>(body.shape)) dGeomSetOffsetQuaternion(made.geom, turn);
    } else {
      place(made.geom, body);
    }
    bodies_.push_back(made);
  }

  void add(const JointShape& shape, const Joint& joint) {
    dBodyID a = body_of(joint.a), b = body_of(joint.b);
    const Vec3 at = (shape.anchor_a + shape.anchor_b) / 2;
    switch (shape.kind) {
      case JointShape::ball_and_socket: {
        dJointID made = dJointCreateBall(world_, nullptr);
        dJointAttach(made, a, b);
        return dJointSetBallAnchor(made, at.x(), at.y(), at.z());
      }
      case JointShape::hinge: {
        dJointID made = dJointCreateHinge(world_, nullptr);
        dJointAttach(made, a, b);
        dJointSetHingeAnchor(made, at.x(), at.y(), at.z());
        hinges_.push_back({made, joint.a, joint.b, shape.axis});
        return dJointSetHingeAxis(made, shape.axis.x(), shape.axis.y(), shape.axis.z());
      }
      case JointShape::angle_limits: {
        const auto [hinge, along] = hinge_of(shape, joint);
        dJointSetHingeParam(hinge, dParamLoStop, along ? shape.low : -shape.high);
        return dJointSetHingeParam(hinge, dParamHiStop, along ? shape.high : -shape.low);
      }
      case JointShape::motor: {
        const auto [hinge, along] = hinge_of(shape, joint);
        dJointSetHingeParam(hinge, dParamVel, along ? shape.speed : -shape.speed);
        return dJointSetHingeParam(hinge, dParamFMax, shape.torque);
      }
      default:
        throw not_had(joint.name);
    }
  }

  /// The hinge that the two have, and whether it turns about the axis of `shape` as ODE counts: its first body against its second.
  /// Of a body and the world, the first is the body.
  std::pair<dJointID, bool> hinge_of(const JointShape& shape, const Joint& joint) const {
    for (const Hinge& hinge : hinges_) {
      if (hinge.a != joint.a || hinge.b != joint.b) continue;
      const bool b_first = body_of(joint.a) == nullptr;
      return {hinge.id, (hinge.axis.dot(shape.axis) > 0) == b_first};
    }
    throw not_had(joint.name + " without the hinge that they are of");
  }

  void collide(dGeomID a, dGeomID b) {
    const dBodyID first = dGeomGetBody(a), second = dGeomGetBody(b);
    if (first == nullptr && second == nullptr) return;
    const auto index_a = reinterpret_cast<std::size_t>(dGeomGetData(a)),
               index_b = reinterpret_cast<std::size_t>(dGeomGetData(b));
    if (joined_.contain(static_cast<int>(index_a), static_cast<int>(index_b))) return;
    const Made &one = bodies_[index_a], &other = bodies_[index_b];
    std::array<dContactGeom, 16> found;
    const int count = dCollide(a, b, static_cast<int>(found.size()), found.data(), sizeof(dContactGeom));
    found_ += count;
    for (int i = 0; i < count; ++i) {
      dContact contact{};
      contact.surface.mode = dContactApprox1 | dContactBounce;
      contact.surface.mu = std::sqrt(one.friction * other.friction);
      contact.surface.bounce = std::max(one.restitution, other.restitution);
      contact.geom = found[static_cast<std::size_t>(i)];
      if (tuned_) align(contact, first, second);
      dJointAttach(dJointCreateContact(world_, contacts_, &contact), first, second);
    }
  }

  bool tuned_;
  dWorldID world_;
  dSpaceID space_;
  dJointGroupID contacts_;
  JoinedPairs joined_;
  std::list<OdeHull> solids_;
  std::vector<Made> bodies_;
  std::vector<Hinge> hinges_;
  int found_ = 0;  // contacts, in the latest step
};

}  // namespace

std::unique_ptr<Engine> begin_engine(const World& world, const PeerSetting& setting) {
  start_ode();
  return std::make_unique<Ode>(world, setting);
}

}  // namespace pushback
