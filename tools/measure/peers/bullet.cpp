/// Bullet 3, in float or in double: BT_USE_DOUBLE_PRECISION says which, and has to fit the libraries.
#include <BulletDynamics/ConstraintSolver/btNNCGConstraintSolver.h>
#include <BulletDynamics/MLCPSolvers/btDantzigSolver.h>
#include <BulletDynamics/MLCPSolvers/btMLCPSolver.h>
#include <btBulletDynamicsCommon.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "pushback/tools/measure/peers/peer.h"

namespace pushback {

namespace {

constexpr btScalar no_limit = 100;  // rad

template <class Solver>
std::unique_ptr<btConstraintSolver> make() {
  return std::make_unique<Solver>();
}

/// What the ways in which it is played differ in. As it comes: with nothing but this solver.
struct Choice {
  std::function<std::unique_ptr<btConstraintSolver>()> solver = make<btSequentialImpulseConstraintSolver>;
  int sweeps = 10;
  /// The number of sweeps means nothing to it. The four corners of a box say too much for it, so that it gives up and sweeps
  /// instead, unless contacts yield a little: J v + softness * impulse = ..., 1/kg.
  bool direct = false;
  btScalar softness = 0;
  /// Friction in two directions, what bounces does so at any speed, and 0.1 mm around a hull, not 40, that overlap where hulls touch.
  bool tuned = true;
  /// Overlap is always removed by a velocity of its own, not only from 4 cm on, and contacts act from where bodies touch,
  /// not from 2 cm before. Else neither a push against overlap nor a gap that is left lets a bounce be what it should.
  bool split = false;
  /// Of a hard case: pairs of their own friction and restitution; where it is tuned, all of the warm start and an ERP of 0.8. Only what
  /// bounces touches from where it touches, and hulls lie on a plane.
  bool hard_case = false;
  /// What moves by more than half of itself in a step is stopped where a ball in it would touch another body.
  bool continuous = false;
};

btVector3 bullet(const Vec3& v) {
  return {static_cast<btScalar>(v.x()), static_cast<btScalar>(v.y()), static_cast<btScalar>(v.z())};
}

btQuaternion bullet(const Quat& q) {
  return {static_cast<btScalar>(q.x()), static_cast<btScalar>(q.y()), static_cast<btScalar>(q.z()),
          static_cast<btScalar>(q.w())};
}

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

/// A half-space is a plane under balls. Under boxes it is a slab of half that depth, m, as Bullet finds one corner of a box on
/// a plane in a step, but all four of a box on a box.
struct Slab {
  bool used;
  btScalar half;

  std::unique_ptr<btCollisionShape> shape_of(const Body& body) const {
    if (const auto* ball = std::get_if<Sphere>(&body.shape))
      return std::make_unique<btSphereShape>(static_cast<btScalar>(ball->radius));
    if (const auto* box = std::get_if<Box>(&body.shape)) return std::make_unique<btBoxShape>(bullet(box->half_extents));
    if (const auto* capsule = std::get_if<Capsule>(&body.shape))
      return std::make_unique<btCapsuleShape>(static_cast<btScalar>(capsule->radius),
                                              static_cast<btScalar>(2 * capsule->half_length));
    if (const auto* hull = std::get_if<Hull>(&body.shape)) {
      auto made = std::make_unique<btConvexHullShape>();
      for (const Vec3& corner : hull->solid->corners) made->addPoint(bullet(corner), false);
      made->recalcLocalAabb();
      return made;
    }
    if (used) return std::make_unique<btBoxShape>(btVector3(half, half, half));
    return std::make_unique<btStaticPlaneShape>(bullet(std::get<HalfSpace>(body.shape).normal), btScalar(0));
  }

  /// Where the shape's origin is and how it is turned.
  btTransform transform_of(const Body& body) const {
    const auto* half_space = std::get_if<HalfSpace>(&body.shape);
    if (half_space == nullptr || !used) return btTransform(bullet(body.orientation), bullet(body.position));
    const btTransform top(bullet(Quat::FromTwoVectors(Vec3::UnitY(), half_space->normal)), bullet(body.position));
    return top * btTransform(btQuaternion::getIdentity(), btVector3(0, -half, 0));
  }
};

/// The inertia is the true one: Bullet's own would be of the shape with its margin around it.
btRigidBody::btRigidBodyConstructionInfo mass_of(const Body& body, btCollisionShape* shape) {
  btRigidBody::btRigidBodyConstructionInfo info(0, nullptr, shape);
  if (body.movable()) {
    info.m_mass = static_cast<btScalar>(1 / body.inverse_mass);
    info.m_localInertia = bullet(Vec3(body.principal_inverse_inertia.cwiseInverse()));
  }
  return info;
}

/// Counts rows where they are swept, a list at once: Bullet ends its iterations where nothing is left to correct. A tangent
/// whose normal presses with nothing is only looked at; it counts.
class Counts {
 public:
  virtual ~Counts() = default;
  double rows_solved = 0;
};
template <class Solver>
class Counting : public Solver, public Counts {
 protected:
  btScalar solveSingleIteration(int iteration, btCollisionObject** bodies, int body_count,
                                btPersistentManifold** manifolds, int manifold_count, btTypedConstraint** constraints,
                                int constraint_count, const btContactSolverInfo& info, btIDebugDraw* drawer) override {
    rows_solved += this->m_tmpSolverNonContactConstraintPool.size() + this->m_tmpSolverContactConstraintPool.size() +
                   this->m_tmpSolverContactFrictionConstraintPool.size();
    return Solver::solveSingleIteration(iteration, bodies, body_count, manifolds, manifold_count, constraints,
                                        constraint_count, info, drawer);
  }
};

/// m/s, of the body's surface.
btVector3 belt_of(const btRigidBody& body) {
  const auto* belt = static_cast<const btVector3*>(body.getUserPointer());
  return belt == nullptr ? btVector3(0, 0, 0) : *belt;
}

/// Called for each contact of each step. Bullet takes the speeds of surfaces along directions of friction that are handed to it: here
/// the same as its own, along the slip and across it.
bool hand_over_belts(btManifoldPoint& point, void* one, void* other) {
  const auto &a = *static_cast<const btRigidBody*>(one), &b = *static_cast<const btRigidBody*>(other);
  const btVector3 wanted = belt_of(b) - belt_of(a);  // of the velocity of a against b
  const btVector3& normal = point.m_normalWorldOnB;
  const auto velocity = [](const btRigidBody& body, const btVector3& at) {
    return body.getVelocityInLocalPoint(at - body.getCenterOfMassPosition());
  };
  btVector3 slip = velocity(a, point.getPositionWorldOnA()) - velocity(b, point.getPositionWorldOnB()) - wanted;
  slip -= normal.dot(slip) * normal;
  if (slip.length2() > SIMD_EPSILON) {
    point.m_lateralFrictionDir1 = slip.normalized();
    point.m_lateralFrictionDir2 = point.m_lateralFrictionDir1.cross(normal);
  } else {
    btPlaneSpace1(normal, point.m_lateralFrictionDir1, point.m_lateralFrictionDir2);
  }
  point.m_contactMotion1 = point.m_lateralFrictionDir1.dot(wanted);
  point.m_contactMotion2 = point.m_lateralFrictionDir2.dot(wanted);
  point.m_contactPointFlags |= BT_CONTACT_FLAG_LATERAL_FRICTION_INITIALIZED;
  return true;
}

class Bullet : public Engine {
 public:
  Bullet(const World& world, const Choice& choice) : choice_(choice), solver_(choice.solver()) {
    const auto any = [&](const auto& is) { return std::any_of(world.bodies.begin(), world.bodies.end(), is); };
    if (choice.hard_case) {
      gCalculateCombinedFrictionCallback = mean_friction;
      gCalculateCombinedRestitutionCallback = larger_restitution;
    }
    dynamics_.emplace(&dispatcher_, &broad_phase_, solver_.get(), &configuration_);
    dynamics_->setGravity(bullet(world.gravity));
    btContactSolverInfo& info = dynamics_->getSolverInfo();
    info.m_numIterations = choice.sweeps;
    if (choice.tuned) {
      info.m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;
      info.m_restitutionVelocityThreshold = 0;
    }
    if (choice.split) info.m_splitImpulsePenetrationThreshold = 0;
    if (choice.tuned && choice.hard_case) {
      info.m_warmstartingFactor = 1;
      info.m_erp = btScalar(0.8);
    }
    const bool belts = any([](const Body& body) { return body.conveys; });
    if (belts) info.m_solverMode |= SOLVER_ENABLE_FRICTION_DIRECTION_CACHING;
    gContactProcessedCallback = belts ? hand_over_belts : nullptr;
    slab_ = {any([&](const Body& body) {
               return std::holds_alternative<Box>(body.shape) ||
                      (!choice.hard_case && std::holds_alternative<Hull>(body.shape));
             }),
             btScalar(choice.hard_case ? 50 : 20)};
    for (const Body& body : world.bodies) add(body);
    for (const HeldPair& pair : held_pairs(world)) add(world, pair);
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
  void push(const Body& body) override {
    its(body).applyCentralForce(bullet(body.force));
    its(body).applyTorque(bullet(body.torque));
  }
  void step(double h) override {
    dynamics_->getSolverInfo().m_globalCfm = choice_.softness * static_cast<btScalar>(h);
    for (const Motor& motor : motors_)
      motor.hinge->setMaxMotorImpulse(static_cast<btScalar>(static_cast<double>(motor.torque) * h));
    dynamics_->stepSimulation(static_cast<btScalar>(h), 0);
  }
  /// Nothing with split impulses either: how often it sweeps those depends on what is left, and it does not say.
  std::optional<double> row_solves() const override {
    const auto* counts = dynamic_cast<const Counts*>(solver_.get());
    if (counts == nullptr || choice_.split) return {};
    return counts->rows_solved;
  }

 private:
  btRigidBody& its(const Body& body) { return its(body.index); }
  btRigidBody& its(int index) {
    return index == the_world ? btTypedConstraint::getFixedBody() : *bodies_[static_cast<std::size_t>(index)];
  }

  /// In a motion all bodies are alike, and a pair has the product of its two.
  btScalar each_of(Real pair) const { return static_cast<btScalar>(choice_.hard_case ? pair : std::sqrt(pair)); }

  void add(const Body& body) {
    shapes_.push_back(slab_.shape_of(body));
    if (choice_.tuned && std::holds_alternative<Hull>(body.shape)) shapes_.back()->setMargin(btScalar(1e-4));
    btRigidBody::btRigidBodyConstructionInfo info = mass_of(body, shapes_.back().get());
    info.m_startWorldTransform = slab_.transform_of(body);
    info.m_friction = each_of(body.friction);
    info.m_restitution = each_of(body.restitution);
    bodies_.push_back(std::make_unique<btRigidBody>(info));
    btRigidBody& made = *bodies_.back();
    if (is_driven(body)) made.setCollisionFlags(made.getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
    if (body.conveys) {
      belts_.push_back(std::make_unique<btVector3>(bullet(body.velocity)));
      made.setUserPointer(belts_.back().get());
    } else {
      made.setLinearVelocity(bullet(body.velocity));
      made.setAngularVelocity(bullet(body.angular_velocity));
    }
    made.setActivationState(DISABLE_DEACTIVATION);
    if (choice_.split && (!choice_.hard_case || body.restitution > 0)) made.setContactProcessingThreshold(0);
    if (choice_.continuous && body.movable()) {
      btVector3 low, high;
      shapes_.back()->getAabb(btTransform::getIdentity(), low, high);
      const btVector3 half = (high - low) / 2;
      made.setCcdMotionThreshold(half[half.minAxis()]);
      made.setCcdSweptSphereRadius(btScalar(0.2) * half[half.minAxis()]);
    }
    dynamics_->addRigidBody(&made);
  }

  /// The frame in the body's that now has its axis `which` along `axis`, and its origin at `at`.
  btTransform frame_on(int index, const Vec3& at, int which, const Vec3& axis) {
    const btTransform there(bullet(Quat::FromTwoVectors(Vec3::Unit(which), axis)), bullet(at));
    return its(index).getCenterOfMassTransform().inverse() * there;
  }

  void add(const World& world, const HeldPair& pair) {
    const Joint& joint = *pair.joint;
    const JointShape& shape = pair.shape;
    btRigidBody &a = its(joint.a), &b = its(joint.b);
    if (shape.kind == JointShape::hinge) {
      auto hinge = std::make_unique<btHingeConstraint>(a, b, frame_on(joint.a, shape.anchor_a, 2, shape.axis),
                                                       frame_on(joint.b, shape.anchor_b, 2, shape.axis), true);
      if (pair.turn) {
        const JointShape turn = turned_to(*pair.turn, shape.axis);
        hinge->setLimit(static_cast<btScalar>(turn.low), static_cast<btScalar>(turn.high), 1);
      }
      if (pair.motor) {
        hinge->enableAngularMotor(true, static_cast<btScalar>(turned_to(*pair.motor, shape.axis).speed), 0);
        motors_.push_back({hinge.get(), pair.motor->torque});
      }
      return add(std::move(hinge), joint);
    }
    const auto local = [&](int index, const Vec3& at) {
      if (choice_.hard_case) return its(index).getCenterOfMassTransform().inverse() * bullet(at);
      const Body& body = world.body(index);
      return bullet(Vec3(body.orientation.conjugate() * (at - body.position)));
    };
    const btVector3 on_b = local(joint.b, shape.anchor_b);
    if (!choice_.hard_case && joint.a == the_world)
      return add(std::make_unique<btPoint2PointConstraint>(b, on_b), joint);
    const btVector3 on_a = local(joint.a, shape.anchor_a);
    add(std::make_unique<btPoint2PointConstraint>(a, b, on_a, on_b), joint);
    if (pair.cone)
      add_turns(joint, on_a, on_b, pair.cone->axis, pair.cone->axis_b, static_cast<btScalar>(pair.cone->high),
                no_limit);
    if (!pair.turn) return;
    if (std::abs(pair.turn->low + pair.turn->high) > Real(1e-4)) throw not_had("twist limits that are not symmetric");
    add_turns(joint, on_a, on_b, pair.turn->axis, pair.turn->axis, no_limit, static_cast<btScalar>(pair.turn->high));
  }
  void add(std::unique_ptr<btTypedConstraint> made, const Joint& joint) {
    dynamics_->addConstraint(made.get(), !joint.colliding);
    joints_.push_back(std::move(made));
  }
  /// The cone of the swing, or the twist. Bullet's joint with both holds two points on each other, too: those of the ball and socket.
  void add_turns(const Joint& joint, const btVector3& at_a, const btVector3& at_b, const Vec3& axis_a,
                 const Vec3& axis_b, btScalar swing, btScalar twist) {
    btTransform on_a = frame_on(joint.a, Vec3::Zero(), 0, axis_a), on_b = frame_on(joint.b, Vec3::Zero(), 0, axis_b);
    on_a.setOrigin(at_a);
    on_b.setOrigin(at_b);
    auto made = std::make_unique<btConeTwistConstraint>(its(joint.a), its(joint.b), on_a, on_b);
    made->setLimit(swing, swing, twist, 1);
    add(std::move(made), joint);
  }

  /// Bullet bounds the impulse of a step: set in each.
  struct Motor {
    btHingeConstraint* hinge;
    Real torque;  // N m
  };

  Choice choice_;
  Slab slab_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broad_phase_;
  std::unique_ptr<btConstraintSolver> solver_;
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btVector3>> belts_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
  std::vector<std::unique_ptr<btTypedConstraint>> joints_;
  std::vector<Motor> motors_;
  std::optional<btDiscreteDynamicsWorld> dynamics_;
};

/// The solver for all constraints at once, with what it needs.
struct Dantzig : private btDantzigSolver, public btMLCPSolver {
  Dantzig() : btMLCPSolver(static_cast<btDantzigSolver*>(this)) {}
};

Method method(const std::string& name, const std::string& title, const Choice& choice) {
  const bool in_double = sizeof(btScalar) == sizeof(double);
  return {.name = (in_double ? "bullet-double" : "bullet") + name,
          .title = title + (in_double ? ", double" : ", float"),
          .plays = choice.direct ? few_bodies : plays_all,
          .begin =
              [choice](const World& world, const Setting& setting) {
                Choice with = choice;
                with.sweeps = setting.sweeps;
                return std::make_unique<Bullet>(world, with);
              },
          .sweeps = !choice.direct};
}

}  // namespace

std::vector<Method> peer_methods() {
  return {
      method("", "Bullet", {.solver = make<Counting<btSequentialImpulseConstraintSolver>>}),
      method("-split", "Bullet, split impulse", {.solver = make<btSequentialImpulseConstraintSolver>, .split = true}),
      method("-nncg", "Bullet, conjugate gradients", {.solver = make<Counting<btNNCGConstraintSolver>>}),
      method("-dantzig", "Bullet, solved directly",
             {.solver = make<Dantzig>, .direct = true, .softness = btScalar(1e-6)})};
}

std::unique_ptr<Engine> begin_engine(const World& world, const PeerSetting& setting) {
  const bool direct = setting.has("dantzig");
  return std::make_unique<Bullet>(world,
                                  Choice{.solver = direct                ? make<Dantzig>
                                                   : setting.has("nncg") ? make<btNNCGConstraintSolver>
                                                                         : make<btSequentialImpulseConstraintSolver>,
                                         .sweeps = setting.sweeps,
                                         .direct = direct,
                                         .softness = direct ? btScalar(1e-6) : 0,
                                         .tuned = setting.tuned,
                                         .split = setting.tuned && !setting.has("joint"),
                                         .hard_case = true,
                                         .continuous = setting.has("continuous")});
}

std::string peer_version() {
  return fmt::format("Bullet {}.{}, {}, {}; called by {}", btGetVersion() / 100, btGetVersion() % 100,
                     sizeof(btScalar) == sizeof(double) ? "double" : "float", PUSHBACK_ENGINE_IS, built_by());
}

}  // namespace pushback
