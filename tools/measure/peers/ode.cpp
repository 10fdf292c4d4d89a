/// ODE plays motions.
#include <fmt/format.h>

#include <array>
#include <list>
#include <map>

#include "pushback/common/basics/input.h"
#include "pushback/tools/measure/peers/ode.h"
#include "pushback/tools/measure/peers/peer.h"
#include "pushback/tools/measure/study/every_motion.h"

namespace pushback {

namespace {

/// What the methods differ in.
struct Choice {
  bool exact = false;    ///< dWorldStep, which solves all constraints of a step at once
  bool aligned = false;  ///< the first direction of friction is that of sliding, not one of its own
};

class Ode : public PlayerInSubsteps {
 public:
  Ode(const Motion& motion, const Setting& setting, const Choice& choice)
      : choice_(choice),
        dt_(setting.dt()),
        world_(dWorldCreate()),
        space_(dHashSpaceCreate(nullptr)),
        contacts_(dJointGroupCreate(0)) {
    dRandSetSeed(0);  // QuickStep sweeps in random order
    World from;
    motion.fill(from);
    dWorldSetGravity(world_, from.gravity.x(), from.gravity.y(), from.gravity.z());
    dWorldSetQuickStepNumIterations(world_, setting.sweeps);
    // Those of the last body are those of all.
    surface_.mode = dContactApprox1 | dContactBounce;
    surface_.mu = static_cast<double>(from.bodies.back().friction);
    surface_.bounce = static_cast<double>(from.bodies.back().restitution);
    surface_.bounce_vel = 0;
    for (const Body& body : from.bodies) add(body);
    for (const Pin& pin : motion.pins) {
      const dJointID joint = dJointCreateBall(world_, nullptr);
      dJointAttach(joint, body_of(pin.a), body_of(pin.b));
      dJointSetBallAnchor(joint, pin.anchor.x(), pin.anchor.y(), pin.anchor.z());
      ++pins_;
    }
  }
  ~Ode() override {
    dJointGroupDestroy(contacts_);
    dSpaceDestroy(space_);
    dWorldDestroy(world_);
  }
  Ode(const Ode&) = delete;
  Ode& operator=(const Ode&) = delete;

  void substep() override {
    rows_ = 3 * pins_;
    for (const Made& made : bodies_)  // a box around it that no number holds would end the program
      if (!(made.place().cwiseAbs().maxCoeff() < 1e8)) throw InvalidInput("a body of ODE is lost");
    dSpaceCollide(space_, this, [](void* ode, dGeomID a, dGeomID b) { static_cast<Ode*>(ode)->collide(a, b); });
    if (without_normal_) throw InvalidInput("ODE finds a contact that has no normal");
    if (choice_.exact) dWorldStep(world_, dt_);
    else dWorldQuickStep(world_, dt_);
    row_solves_ += static_cast<double>(rows_) * dWorldGetQuickStepNumIterations(world_);
    dJointGroupEmpty(contacts_);
  }
  Eigen::Vector3d place(std::size_t body) const override { return bodies_[body].place(); }
  /// QuickStep goes over all rows in each of its iterations, and stops after no fewer.
  std::optional<double> row_solves() const override {
    if (choice_.exact) return {};
    return row_solves_;
  }

 private:
  struct Made {
    dBodyID body;  // null for one that nothing moves
    dGeomID geom;
    Eigen::Vector3d still;

    Eigen::Vector3d place() const {
      return body == nullptr ? still : Eigen::Vector3d(Eigen::Map<const Eigen::Vector3d>(dBodyGetPosition(body)));
    }
  };

  dBodyID body_of(int index) const {
    return index == the_world ? nullptr : bodies_[static_cast<std::size_t>(index)].body;
  }

  void add(const Body& body) {
    Made made{nullptr, nullptr, body.position.cast<double>()};
    if (const auto* half_space = std::get_if<HalfSpace>(&body.shape)) {
      const Vec3& n = half_space->normal;
      made.geom = dCreatePlane(space_, n.x(), n.y(), n.z(), n.dot(body.position));
      if (body.conveys) belts_[made.geom] = body.velocity.cast<double>();
      bodies_.push_back(made);
      return;
    }
    if (const auto* ball = std::get_if<Sphere>(&body.shape)) {
      made.geom = dCreateSphere(space_, ball->radius);
    } else if (const auto* hull = std::get_if<Hull>(&body.shape)) {
      made.geom = solids_.emplace_back(*hull->solid).made(space_);
    } else {
      const Vec3 lengths = 2 * std::get<Box>(body.shape).half_extents;
      made.geom = dCreateBox(space_, lengths.x(), lengths.y(), lengths.z());
    }
    made.body = dBodyCreate(world_);
    const dMass mass = mass_of(body);
    dBodySetMass(made.body, &mass);
    dGeomSetBody(made.geom, made.body);
    put_where(made.body, body);
    bodies_.push_back(made);
  }

  /// m/s, of its surface.
  Eigen::Vector3d belt_of(dGeomID geom) const {
    const auto found = belts_.find(geom);
    return found == belts_.end() ? Eigen::Vector3d::Zero() : found->second;
  }

  void collide(dGeomID a, dGeomID b) {
    const dBodyID first = dGeomGetBody(a), second = dGeomGetBody(b);
    if (first != nullptr && second != nullptr && dAreConnectedExcluding(first, second, dJointTypeContact) != 0) return;
    std::array<dContactGeom, 16> found;
    const int count = dCollide(a, b, static_cast<int>(found.size()), found.data(), sizeof(dContactGeom));
    for (int i = 0; i < count; ++i) {
      dContact contact{};
      contact.surface = surface_;
      contact.geom = found[static_cast<std::size_t>(i)];
      without_normal_ = without_normal_ || Eigen::Map<const Eigen::Vector3d>(contact.geom.normal).isZero(0);
      if (choice_.aligned) align(contact, first, second, belt_of(a) - belt_of(b));
      if (!belts_.empty()) convey(contact, belt_of(a) + belt_of(b), first == nullptr);
      dJointAttach(dJointCreateContact(world_, contacts_, &contact), first, second);
    }
    rows_ += count * (surface_.mu > 0 ? 3 : 1);  // no tangents where nothing rubs
  }

  Choice choice_;
  double dt_;
  dWorldID world_;
  dSpaceID space_;
  dJointGroupID contacts_;
  dSurfaceParameters surface_{};
  std::list<OdeHull> solids_;
  std::vector<Made> bodies_;
  std::map<dGeomID, Eigen::Vector3d> belts_;  // looked up, never gone through
  int pins_ = 0;
  bool without_normal_ = false;  // so it is where hulls meet face to face: a step would end the program
  int rows_ = 0;                 // of the latest step
  double row_solves_ = 0;        // of all
};

Method method(const std::string& name, const std::string& title, const Choice& choice) {
  return {.name = name,
          .title = title,
          // Solved directly, all rows make one dense matrix: those of a thousand bodies at rest would take 14 GB.
          .plays = [choice](const Motion& motion) { return !choice.exact || moving_bodies(motion) <= 200; },
          .begin = [choice](const Motion& motion, const Setting& setting) -> std::unique_ptr<Player> {
            start_ode();
            return std::make_unique<Ode>(motion, setting, choice);
          },
          .sweeps = !choice.exact};
}

}  // namespace

std::vector<Method> peer_methods() {
  return {method("ode", "ODE, QuickStep", {}),
          method("ode-aligned", "ODE, QuickStep, friction along sliding", {.aligned = true}),
          method("ode-exact", "ODE, solved directly, friction along sliding", {.exact = true, .aligned = true})};
}

std::string peer_version() {
  return fmt::format("ODE {}, {}; called by {}", dODE_VERSION, dGetConfiguration(), built_by());
}

}  // namespace pushback
