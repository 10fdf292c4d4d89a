/// ODE.
#include <fmt/format.h>
#include <ode/ode.h>

#include <array>
#include <cmath>
#include <limits>
#include <list>
#include <map>

#include "pushback/common/basics/input.h"
#include "pushback/tools/measure/peers/peer.h"

namespace pushback {

namespace {

/// What the ways in which it is played differ in. As it comes: none of these.
struct Choice {
  int sweeps = 20;
  /// So many contacts at most are solved by dWorldStep, all constraints of a step at once; more by sweeps. 0: always by sweeps.
  int most_direct = 0;
  bool aligned = false;  ///< the first direction of friction is that of sliding, not one of its own
  bool gentle = false;   ///< overlap stays up to 0.5 mm, and is pushed out at 3 m/s at most
  /// Throws where a step would end the program. In a hard case it does, and the table says that it crashed.
  bool says_why = true;
};

constexpr int any_number = std::numeric_limits<int>::max();

/// Once in a program, before anything else. Where ODE cannot solve a step it would say so, once for each, and go on: errors tell.
void start_ode() {
  static const bool ready = dInitODE2(0) != 0;
  if (!ready) throw std::runtime_error("ODE does not start");
  dSetMessageHandler([](int, const char*, va_list) {});
}

/// A hull as ODE wants it, which does not copy it.
struct OdeHull {
  std::vector<dReal> planes, points;
  std::vector<unsigned int> polygons;

  explicit OdeHull(const Polyhedron& solid) {
    for (const Polyhedron::Face& face : solid.faces) {
      planes.insert(planes.end(), {face.normal.x(), face.normal.y(), face.normal.z(), face.offset});
      polygons.push_back(static_cast<unsigned int>(face.corners.size()));
      polygons.insert(polygons.end(), face.corners.begin(), face.corners.end());
    }
    for (const Vec3& corner : solid.corners) points.insert(points.end(), {corner.x(), corner.y(), corner.z()});
  }
  dGeomID made(dSpaceID space) const {
    return dCreateConvex(space, planes.data(), static_cast<unsigned int>(planes.size() / 4), points.data(),
                         static_cast<unsigned int>(points.size() / 3), polygons.data());
  }
};

dMass mass_of(const Body& body) {
  const Eigen::Vector3d inertia = body.principal_inverse_inertia.cast<double>().cwiseInverse();
  dMass mass;
  dMassSetParameters(&mass, 1 / static_cast<double>(body.inverse_mass), 0, 0, 0, inertia.x(), inertia.y(), inertia.z(),
                     0, 0, 0);
  return mass;
}

void put_where(dBodyID made, const Body& body) {
  const Eigen::Quaterniond q = body.orientation.cast<double>();
  const dQuaternion turn{q.w(), q.x(), q.y(), q.z()};
  dBodySetPosition(made, body.position.x(), body.position.y(), body.position.z());
  dBodySetQuaternion(made, turn);
  dBodySetLinearVel(made, body.velocity.x(), body.velocity.y(), body.velocity.z());
  dBodySetAngularVel(made, body.angular_velocity.x(), body.angular_velocity.y(), body.angular_velocity.z());
}

Eigen::Vector3d place_of(dBodyID body) {
  return Eigen::Map<const Eigen::Vector3d>(dBodyGetPosition(body));
}

Eigen::Vector3d velocity_at(dBodyID body, const dVector3& point) {
  dVector3 velocity{};
  if (body != nullptr) dBodyGetPointVel(body, point[0], point[1], point[2], velocity);
  return {velocity[0], velocity[1], velocity[2]};
}

/// The first direction of friction becomes that of sliding, where there is any. `runs`: m/s, of a's surface over a, less that of b's.
void align(dContact& contact, dBodyID a, dBodyID b, const Eigen::Vector3d& runs = Eigen::Vector3d::Zero()) {
  const Eigen::Map<const Eigen::Vector3d> n(contact.geom.normal);
  Eigen::Vector3d sliding = velocity_at(a, contact.geom.pos) - velocity_at(b, contact.geom.pos) + runs;
  sliding -= n.dot(sliding) * n;
  if (sliding.norm() < 1e-6) return;
  contact.surface.mode |= dContactFDir1;
  Eigen::Map<Eigen::Vector3d>(contact.fdir1) = sliding.normalized();
}

/// One of the two is no body, and its surface runs with `belt`, m/s: friction pulls the other one towards that. ODE asks for the speeds
/// along its two directions, t1 and n x t1, so t1 has to be said. `turned`: the body is the second of the two, and n is turned round.
void convey(dContact& contact, const Eigen::Vector3d& belt, bool turned) {
  const Eigen::Vector3d n = (turned ? -1 : 1) * Eigen::Map<const Eigen::Vector3d>(contact.geom.normal);
  Eigen::Map<Eigen::Vector3d> t1(contact.fdir1);
  if ((contact.surface.mode & dContactFDir1) == 0) {
    dVector3 second;
    const dVector3 normal{n.x(), n.y(), n.z()};
    dPlaneSpace(normal, contact.fdir1, second);
  }
  contact.surface.mode |= dContactFDir1 | dContactMotion1 | dContactMotion2;
  contact.surface.motion1 = belt.dot(t1);
  contact.surface.motion2 = belt.dot(n.cross(t1));
}

class Ode : public Engine {
 public:
  Ode(const World& world, const Choice& choice) : choice_(choice), joined_(world.joints) {
    start_ode();
    world_ = dWorldCreate();
    space_ = dHashSpaceCreate(nullptr);
    contacts_ = dJointGroupCreate(0);
    dRandSetSeed(0);  // QuickStep sweeps in random order
    dWorldSetGravity(world_, world.gravity.x(), world.gravity.y(), world.gravity.z());
    dWorldSetQuickStepNumIterations(world_, choice.sweeps);
    if (choice.gentle) {
      dWorldSetContactMaxCorrectingVel(world_, 3);
      dWorldSetContactSurfaceLayer(world_, 5e-4);
    }
    for (const Body& body : world.bodies) add(body);
    for (const HeldPair& pair : held_pairs(
             world, {JointShape::ball_and_socket, JointShape::hinge, JointShape::angle_limits, JointShape::motor}))
      add(pair);
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
  void push(const Body& body) override {
    dBodyID made = body_of(body.index);
    dBodyAddForce(made, body.force.x(), body.force.y(), body.force.z());
    dBodyAddTorque(made, body.torque.x(), body.torque.y(), body.torque.z());
  }
  void step(double h) override {
    for (const Made& made : bodies_)  // a box around it that no number holds would end the program
      if (choice_.says_why && made.body != nullptr && !(place_of(made.body).cwiseAbs().maxCoeff() < 1e8))
        throw InvalidInput("a body of ODE is lost");
    found_ = 0;
    rows_ = 3 * joints_;
    dSpaceCollide(space_, this, [](void* ode, dGeomID a, dGeomID b) { static_cast<Ode*>(ode)->collide(a, b); });
    if (choice_.says_why && without_normal_) throw InvalidInput("ODE finds a contact that has no normal");
    if (choice_.most_direct > 0 && found_ <= choice_.most_direct) dWorldStep(world_, h);
    else dWorldQuickStep(world_, h);
    row_solves_ += static_cast<double>(rows_) * dWorldGetQuickStepNumIterations(world_);
    dJointGroupEmpty(contacts_);
  }
  /// QuickStep goes over all rows in each of its iterations, and stops after no fewer.
  std::optional<double> row_solves() const override {
    if (choice_.most_direct > 0) return {};
    return row_solves_;
  }

 private:
  struct Made {
    dBodyID body;  // null for one that nothing moves
    dGeomID geom;
    double friction, restitution;
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
      if (body.conveys) belts_[made.geom] = body.velocity.cast<double>();
    }
    bodies_.push_back(made);
  }

  void add(const HeldPair& pair) {
    ++joints_;
    const bool hinge = pair.shape.kind == JointShape::hinge;
    dBodyID a = body_of(pair.joint->a), b = body_of(pair.joint->b);
    const Vec3 at = (pair.shape.anchor_a + pair.shape.anchor_b) / 2, &axis = pair.shape.axis;
    dJointID made = hinge ? dJointCreateHinge(world_, nullptr) : dJointCreateBall(world_, nullptr);
    dJointAttach(made, a, b);
    if (!hinge) return dJointSetBallAnchor(made, at.x(), at.y(), at.z());
    dJointSetHingeAnchor(made, at.x(), at.y(), at.z());
    dJointSetHingeAxis(made, axis.x(), axis.y(), axis.z());
    // ODE counts the turn of its first body against its second. Of a body and the world, the first is the body.
    const Vec3 counted = a == nullptr ? axis : Vec3(-axis);
    if (pair.turn) {
      const JointShape turn = turned_to(*pair.turn, counted);
      dJointSetHingeParam(made, dParamLoStop, turn.low);
      dJointSetHingeParam(made, dParamHiStop, turn.high);
    }
    if (pair.motor) {
      dJointSetHingeParam(made, dParamVel, turned_to(*pair.motor, counted).speed);
      dJointSetHingeParam(made, dParamFMax, pair.motor->torque);
    }
  }

  /// m/s, of its surface.
  Eigen::Vector3d belt_of(dGeomID geom) const {
    const auto found = belts_.find(geom);
    return found == belts_.end() ? Eigen::Vector3d::Zero() : found->second;
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
    rows_ += count * (one.friction > 0 && other.friction > 0 ? 3 : 1);  // no tangents where nothing rubs
    for (int i = 0; i < count; ++i) {
      dContact contact{};
      contact.surface.mode = dContactApprox1 | dContactBounce;
      contact.surface.mu = std::sqrt(one.friction * other.friction);
      contact.surface.bounce = std::max(one.restitution, other.restitution);
      contact.geom = found[static_cast<std::size_t>(i)];
      without_normal_ = without_normal_ || Eigen::Map<const Eigen::Vector3d>(contact.geom.normal).isZero(0);
      if (choice_.aligned) align(contact, first, second, belt_of(a) - belt_of(b));
      if (!belts_.empty()) convey(contact, belt_of(a) + belt_of(b), first == nullptr);
      dJointAttach(dJointCreateContact(world_, contacts_, &contact), first, second);
    }
  }

  Choice choice_;
  dWorldID world_;
  dSpaceID space_;
  dJointGroupID contacts_;
  JoinedPairs joined_;
  std::list<OdeHull> solids_;
  std::vector<Made> bodies_;
  std::map<dGeomID, Eigen::Vector3d> belts_;  // looked up, never gone through
  int joints_ = 0;
  bool without_normal_ = false;  // so it is where hulls meet face to face: a step would end the program
  int found_ = 0, rows_ = 0;     // contacts, and their rows, in the latest step
  double row_solves_ = 0;        // of all
};

Method method(const std::string& name, const std::string& title, const Choice& choice) {
  return {.name = name,
          .title = title,
          .plays = choice.most_direct > 0 ? few_bodies : plays_all,
          .begin =
              [choice](const World& world, const Setting& setting) {
                Choice with = choice;
                with.sweeps = setting.sweeps;
                return std::make_unique<Ode>(world, with);
              },
          .sweeps = choice.most_direct == 0};
}

}  // namespace

std::vector<Method> peer_methods() {
  return {method("ode", "ODE, QuickStep", {}),
          method("ode-aligned", "ODE, QuickStep, friction along sliding", {.aligned = true}),
          method("ode-exact", "ODE, solved directly, friction along sliding",
                 {.most_direct = any_number, .aligned = true})};
}

std::unique_ptr<Engine> begin_engine(const World& world, const PeerSetting& setting) {
  // Of more than 16, as in a stack of ten, bodies fly off.
  return std::make_unique<Ode>(world, Choice{.sweeps = setting.sweeps,
                                             .most_direct = setting.has("direct") ? any_number
                                                            : setting.has("few")  ? 16
                                                                                  : 0,
                                             .aligned = setting.tuned,
                                             .gentle = setting.tuned,
                                             .says_why = false});
}

std::string peer_version() {
  return fmt::format("ODE {}, {}, {}; called by {}", dODE_VERSION, dGetConfiguration(), PUSHBACK_ENGINE_IS, built_by());
}

}  // namespace pushback
