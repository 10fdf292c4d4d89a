/// MuJoCo plays motions.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "pushback/common/basics/input.h"
#include "pushback/tools/peers/mujoco.h"
#include "pushback/tools/peers/peer.h"
#include "pushback/tools/study/every_motion.h"

namespace pushback {

namespace {

/// What the methods differ in.
struct Choice {
  std::string solver = "Newton";
  std::string integrator = "Euler";
  bool hard = true;      ///< as hard as it goes; else as it comes
  bool bounces = false;  ///< contacts are springs and dampers that give the motion's restitution
  bool noslip = false;   ///< friction as stiff as its makers advise, and ten sweeps that take out the slip that is left
  bool connect = false;  ///< pins are constraints, not the joints of a tree
};

/// The share of critical damping, sin(phi), of a contact that is left with the fraction e of the speed it met with. A spring and
/// damper that pushes and never pulls lets go as its force ends, after the angle pi - 2 phi, so e = exp(-(pi - 2 phi) tan(phi)).
double damping_of(double e) {
  double low = 0, high = std::numbers::pi / 2;
  for (int i = 0; i < 60; ++i) {
    const double phi = (low + high) / 2;
    (std::exp(-(std::numbers::pi - 2 * phi) * std::tan(phi)) > e ? low : high) = phi;
  }
  return std::sin(low);
}

/// A world as MJCF. Bodies are called b0, b1 ... by their index.
class Mjcf {
 public:
  Mjcf(const Motion& motion, const World& world, const Setting& setting, const Choice& choice)
      : world_(world), pins_(choice.connect ? std::vector<Pin>{} : motion.pins) {
    // The least time constant that it allows, the largest impedance, and contacts from 1 um before they touch, without which
    // bodies that just touch fall freely in the first step. It comes with 0.02 s, 0.9 to 0.95, and 0.
    // Of a spring that bounces, 1/s. A bounce is of pi / rate, and its restitution off by some rate * dt: both fall with dt.
    const double rate = std::min(30.0 * setting.substeps, 120 * std::sqrt(setting.substeps));
    const std::string reference =
        choice.bounces ? fmt::format("{:.17g} {:.17g}", -rate * rate,
                                     -2 * damping_of(static_cast<double>(world.bodies.back().restitution)) * rate)
                       : fmt::format("{:.17g} 1", 2 * setting.dt());
    const std::string impedance = choice.hard ? fmt::format("solref='{}' solimp='0.9999 0.9999 0.001'", reference) : "";
    const std::string joints = fmt::format("solref='{:.17g} 1' solimp='0.9999 0.9999 0.001'", 2 * setting.dt());
    const std::string effort =
        choice.solver == "PGS" ? fmt::format("iterations='{}' tolerance='0'", setting.sweeps) : "tolerance='1e-12'";
    text_ = fmt::format(
        "<mujoco><compiler angle='radian'/><size njmax='3000' nconmax='1000'/>"
        "<option timestep='{:.17g}' gravity='{}' solver='{}' {} integrator='{}' cone='elliptic'{}/>"
        "<default><geom condim='{}' friction='{:.17g} 0 0' margin='{}' {}/><equality {}/></default><worldbody>",
        setting.dt(), text(world.gravity), choice.solver, effort, choice.integrator,
        choice.noslip ? " impratio='10' noslip_iterations='10'" : "", world.bodies.back().friction > 0 ? 3 : 1,
        world.bodies.back().friction, choice.hard ? "1e-6" : "0", impedance, choice.hard ? joints : "");
    for (const Body& body : world.bodies)
      if (pin_of(body) == nullptr || pin_of(body)->a == the_world) add(body, Vec3::Zero(), Quat::Identity());
    text_ += "</worldbody>";
    if (choice.connect) connect(motion.pins);
    text_ += "</mujoco>";
  }
  const std::string& operator()() const { return text_; }

 private:
  /// Whether there are several. Then they are of the world, not each of a body of its own: with two such bodies and few others, MuJoCo 2.2.2 ends with
  /// "Broadphase buffer full", as each is a pair with every body, also with the other.
  bool several_planes() const {
    return std::count_if(world_.bodies.begin(), world_.bodies.end(),
                         [](const Body& body) { return std::holds_alternative<HalfSpace>(body.shape); }) > 1;
  }

  /// What hangs this body on another, or on the world.
  const Pin* pin_of(const Body& body) const {
    for (const Pin& pin : pins_)
      if (pin.b == body.index) return &pin;
    return nullptr;
  }

  /// The body in the frame of the one that it hangs on, and in it those that hang on it.
  void add(const Body& body, const Vec3& from, const Quat& turn) {
    const Vec3 at = turn.conjugate() * (body.position - from);
    const Quat turned = turn.conjugate() * body.orientation;
    if (const auto* half_space = std::get_if<HalfSpace>(&body.shape)) {
      const Quat up = Quat::FromTwoVectors(Vec3::UnitZ(), half_space->normal);
      const std::string where = fmt::format("pos='{}' quat='{}'", text(at), text(up));
      text_ += several_planes()
                   ? fmt::format("<geom type='plane' size='0 0 1' {}/>", where)
                   : fmt::format("<body name='b{}' {}><geom type='plane' size='0 0 1'/></body>", body.index, where);
      return;
    }
    text_ += fmt::format("<body name='b{}' pos='{}' quat='{}'>", body.index, text(at), text(turned));
    if (const Pin* pin = pin_of(body))
      text_ += fmt::format("<joint type='ball' pos='{}'/>",
                           text(Vec3(body.orientation.conjugate() * (pin->anchor - body.position))));
    else text_ += "<freejoint/>";
    text_ += fmt::format("<inertial pos='0 0 0' mass='{:.17g}' diaginertia='{}'/>", 1 / body.inverse_mass,
                         text(Vec3(body.principal_inverse_inertia.cwiseInverse())));
    if (const auto* ball = std::get_if<Sphere>(&body.shape))
      text_ += fmt::format("<geom type='sphere' size='{:.17g}'/>", ball->radius);
    else text_ += fmt::format("<geom type='box' size='{}'/>", text(std::get<Box>(body.shape).half_extents));
    for (const Pin& pin : pins_)
      if (pin.a == body.index) add(world_.bodies[static_cast<std::size_t>(pin.b)], body.position, body.orientation);
    text_ += "</body>";
  }

  void connect(const std::vector<Pin>& pins) {
    text_ += "<equality>";
    for (const Pin& pin : pins) {
      const Body& b = world_.bodies[static_cast<std::size_t>(pin.b)];
      text_ += fmt::format("<connect body1='b{}' {}anchor='{}'/>", pin.b,
                           pin.a == the_world ? "" : fmt::format("body2='b{}' ", pin.a),
                           text(Vec3(b.orientation.conjugate() * (pin.anchor - b.position))));
    }
    text_ += "</equality><contact>";
    for (const Pin& pin : pins)
      if (pin.a != the_world) text_ += fmt::format("<exclude body1='b{}' body2='b{}'/>", pin.a, pin.b);
    text_ += "</contact>";
  }

  const World& world_;
  std::vector<Pin> pins_;
  std::string text_;
};

class Mujoco : public PlayerInSubsteps {
 public:
  Mujoco(const Motion& motion, const Setting& setting, const Choice& choice) {
    World world;
    motion.fill(world);
    model_ = model_of(Mjcf(motion, world, setting, choice)());
    data_.reset(mj_makeData(model_.get()));
    for (const Body& body : world.bodies) {
      still_.push_back(body.position.cast<double>());
      if (!body.movable()) {
        ids_.push_back(-1);
        continue;
      }
      ids_.push_back(mj_name2id(model_.get(), mjOBJ_BODY, fmt::format("b{}", body.index).c_str()));
      const int joint = model_->body_jntadr[ids_.back()];
      if (joint < 0) continue;
      // Of a free joint: the velocity in world axes, and as of a ball the angular velocity in those of the body. Of a ball it is
      // against what the body hangs on, which in all motions begins without one.
      double* velocity = data_->qvel + model_->jnt_dofadr[joint];
      if (model_->jnt_type[joint] == mjJNT_FREE) {
        Eigen::Map<Eigen::Vector3d> moving(velocity);
        moving = body.velocity.cast<double>();
        velocity += 3;
      }
      Eigen::Map<Eigen::Vector3d> turning(velocity);
      turning = (body.orientation.conjugate() * body.angular_velocity).cast<double>();
    }
  }

  void substep() override {
    mj_step(model_.get(), data_.get());
    moved_ = true;
    row_solves_ += static_cast<double>(data_->nefc) * data_->solver_iter;
    if (const char* lost = lost_by(*data_)) throw InvalidInput(lost);
  }
  Eigen::Vector3d place(std::size_t body) const override {
    if (ids_[body] < 0) return still_[body];
    if (moved_) mj_kinematics(model_.get(), data_.get());  // a step leaves the places of where it began
    moved_ = false;
    return Eigen::Map<const Eigen::Vector3d>(data_->xipos + 3 * ids_[body]);
  }
  std::optional<double> row_solves() const override {
    if (model_->opt.solver != mjSOL_PGS) return {};
    return row_solves_;
  }

 private:
  MujocoModel model_;
  MujocoData data_;
  std::vector<int> ids_;  // -1: nothing moves the body
  Places still_;          // where the bodies were at first
  mutable bool moved_ = true;
  double row_solves_ = 0;
};

/// Of a thousand bodies at rest the rows have no room: a step has a dense matrix of rows and velocities, and 2 GB at most.
constexpr int most_bodies = 200;

/// What its contacts must be able to do, and what only some methods are for.
enum class For { all, pins, friction };

Method method(const std::string& name, const std::string& title, const Choice& choice, For what = For::all) {
  return {.name = name,
          .title = title,
          .plays =
              [what, bounces = choice.bounces](const Motion& motion) {
                World world;
                motion.fill(world);  // MuJoCo has no restitution, but springs
                return (world.bodies.back().restitution > 0) == bounces && !has_conveyor(motion) &&
                       moving_bodies(motion) <= most_bodies && (what != For::pins || !motion.pins.empty()) &&
                       (what != For::friction || has_contacts(motion));
              },
          .begin = [choice](const Motion& motion, const Setting& setting) -> std::unique_ptr<Player> {
            return std::make_unique<Mujoco>(motion, setting, choice);
          },
          .sweeps = choice.solver == "PGS"};
}

}  // namespace

std::vector<Method> peer_methods() {
  return {method("mujoco", "MuJoCo, hard", {}),
          method("mujoco-default", "MuJoCo, as it comes", {.hard = false}),
          method("mujoco-pgs", "MuJoCo, hard, sweeps", {.solver = "PGS"}),
          method("mujoco-noslip", "MuJoCo, hard, without slip", {.noslip = true}, For::friction),
          method("mujoco-bounce", "MuJoCo, springs that bounce", {.bounces = true}),
          method("mujoco-rk4", "MuJoCo, Runge and Kutta", {.integrator = "RK4"}, For::pins),
          method("mujoco-connect", "MuJoCo, pins as constraints", {.connect = true}, For::pins)};
}

std::string peer_version() {
  return fmt::format("MuJoCo {}, double; called by {}", mj_versionString(), built_by());
}

}  // namespace pushback
