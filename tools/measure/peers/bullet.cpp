/// Bullet 3 plays motions, in float or in double: BT_USE_DOUBLE_PRECISION says which, and has to fit the libraries.
#include <BulletDynamics/ConstraintSolver/btNNCGConstraintSolver.h>
#include <BulletDynamics/MLCPSolvers/btDantzigSolver.h>
#include <BulletDynamics/MLCPSolvers/btMLCPSolver.h>
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "pushback/tools/measure/peers/bullet.h"
#include "pushback/tools/measure/peers/peer.h"
#include "pushback/tools/measure/study/every_motion.h"

namespace pushback {

namespace {

/// What the methods differ in.
struct Choice {
  std::function<std::unique_ptr<btConstraintSolver>()> solver;
  /// The number of sweeps means nothing to it. The four corners of a box say too much for it, so that it gives up and sweeps
  /// instead, unless contacts yield a little: J v + softness * impulse = ..., 1/kg.
  bool direct = false;
  btScalar softness = 0;
  /// Overlap is always removed by a velocity of its own, not only from 4 cm on, and contacts act from where bodies touch,
  /// not from 2 cm before. Else neither a push against overlap nor a gap that is left lets a bounce be what it should.
  bool split = false;
};

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

class Bullet : public PlayerInSubsteps {
 public:
  Bullet(const Motion& motion, const Setting& setting, const Choice& choice)
      : choice_(choice), solver_(choice.solver()), dt_(static_cast<btScalar>(setting.dt())) {
    World world;
    motion.fill(world);
    dynamics_.emplace(&dispatcher_, &broad_phase_, solver_.get(), &configuration_);
    dynamics_->setGravity(bullet(world.gravity));
    btContactSolverInfo& info = dynamics_->getSolverInfo();
    info.m_numIterations = setting.sweeps;
    info.m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;
    info.m_restitutionVelocityThreshold = 0;
    info.m_globalCfm = choice.softness * dt_;
    if (choice.split) info.m_splitImpulsePenetrationThreshold = 0;
    const bool belts = has_conveyor(motion);
    if (belts) info.m_solverMode |= SOLVER_ENABLE_FRICTION_DIRECTION_CACHING;
    gContactProcessedCallback = belts ? hand_over_belts : nullptr;
    slab_.used = std::any_of(world.bodies.begin(), world.bodies.end(), [](const Body& body) {
      return std::holds_alternative<Box>(body.shape) || std::holds_alternative<Hull>(body.shape);
    });
    for (const Body& body : world.bodies) add(body);
    for (const Pin& pin : motion.pins) add(pin, world);
  }
  ~Bullet() override {
    for (const auto& pin : pins_) dynamics_->removeConstraint(pin.get());
    for (const auto& body : bodies_) dynamics_->removeRigidBody(body.get());
  }

  void substep() override { dynamics_->stepSimulation(dt_, 0); }
  Eigen::Vector3d place(std::size_t body) const override {
    if (bodies_[body]->isStaticObject()) return put_[body];
    const btVector3& at = bodies_[body]->getCenterOfMassPosition();
    return {static_cast<double>(at.x()), static_cast<double>(at.y()), static_cast<double>(at.z())};
  }
  /// Nothing with split impulses either: how often it sweeps those depends on what is left, and it does not say.
  std::optional<double> row_solves() const override {
    const auto* counts = dynamic_cast<const Counts*>(solver_.get());
    if (counts == nullptr || choice_.split) return {};
    return counts->rows_solved;
  }

 private:
  void add(const Body& body) {
    shapes_.push_back(slab_.shape_of(body));
    // 0.04 m around a hull, else, that overlap where hulls touch.
    if (std::holds_alternative<Hull>(body.shape)) shapes_.back()->setMargin(btScalar(1e-4));
    put_.push_back(body.position.cast<double>());
    btRigidBody::btRigidBodyConstructionInfo info = mass_of(body, shapes_.back().get());
    info.m_startWorldTransform = slab_.transform_of(body);
    info.m_friction = static_cast<btScalar>(std::sqrt(body.friction));  // a pair has the product of its two
    info.m_restitution = static_cast<btScalar>(std::sqrt(body.restitution));
    bodies_.push_back(std::make_unique<btRigidBody>(info));
    btRigidBody& made = *bodies_.back();
    if (body.conveys) {
      belts_.push_back(std::make_unique<btVector3>(bullet(body.velocity)));
      made.setUserPointer(belts_.back().get());
    } else {
      made.setLinearVelocity(bullet(body.velocity));
      made.setAngularVelocity(bullet(body.angular_velocity));
    }
    made.setActivationState(DISABLE_DEACTIVATION);
    if (choice_.split) made.setContactProcessingThreshold(0);
    dynamics_->addRigidBody(&made);
  }

  void add(const Pin& pin, const World& world) {
    const auto local = [&](int index) {
      const Body& body = world.bodies[static_cast<std::size_t>(index)];
      return bullet(Vec3(body.orientation.conjugate() * (pin.anchor - body.position)));
    };
    btRigidBody& b = *bodies_[static_cast<std::size_t>(pin.b)];
    if (pin.a == the_world) pins_.push_back(std::make_unique<btPoint2PointConstraint>(b, local(pin.b)));
    else
      pins_.push_back(std::make_unique<btPoint2PointConstraint>(*bodies_[static_cast<std::size_t>(pin.a)], b,
                                                                local(pin.a), local(pin.b)));
    dynamics_->addConstraint(pins_.back().get(), true);  // true: the two do not collide
  }

  Choice choice_;
  Slab slab_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broad_phase_;
  std::unique_ptr<btConstraintSolver> solver_;
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btVector3>> belts_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
  std::vector<std::unique_ptr<btTypedConstraint>> pins_;
  Places put_;  // where the bodies were at first, of which those that nothing moves have another origin here
  std::optional<btDiscreteDynamicsWorld> dynamics_;
  btScalar dt_;
};

template <class Solver>
std::unique_ptr<btConstraintSolver> make() {
  return std::make_unique<Solver>();
}

/// The solver for all constraints at once, with what it needs.
struct Dantzig : private btDantzigSolver, public btMLCPSolver {
  Dantzig() : btMLCPSolver(static_cast<btDantzigSolver*>(this)) {}
};

Method method(const std::string& name, const std::string& title, const Choice& choice) {
  const bool in_double = sizeof(btScalar) == sizeof(double);
  return {.name = (in_double ? "bullet-double" : "bullet") + name,
          .title = title + (in_double ? ", double" : ", float"),
          // Solved directly, all rows make one dense matrix: those of a thousand bodies at rest would take 14 GB.
          .plays = [choice](const Motion& motion) { return !choice.direct || moving_bodies(motion) <= 200; },
          .begin = [choice](const Motion& motion, const Setting& setting) -> std::unique_ptr<Player> {
            return std::make_unique<Bullet>(motion, setting, choice);
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

std::string peer_version() {
  return fmt::format("Bullet {}.{}, {}; called by {}", btGetVersion() / 100, btGetVersion() % 100,
                     sizeof(btScalar) == sizeof(double) ? "double" : "float", built_by());
}

}  // namespace pushback
