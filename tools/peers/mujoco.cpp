/// MuJoCo plays motions.
#include <fmt/format.h>

#include "pushback/common/basics/input.h"
#include "pushback/tools/peers/mujoco.h"
#include "pushback/tools/peers/peer.h"

namespace pushback {

namespace {

/// What the methods differ in.
struct Choice {
  std::string solver = "Newton";
  std::string integrator = "Euler";
  bool hard = true;      ///< as hard as it goes; else as it comes
  bool connect = false;  ///< pins are constraints, not the joints of a tree
};

/// A world as MJCF. Bodies are called b0, b1 ... by their index.
class Mjcf {
 public:
  Mjcf(const Motion& motion, const World& world, const Setting& setting, const Choice& choice)
      : world_(world), pins_(choice.connect ? std::vector<Pin>{} : motion.pins) {
    // The least time constant that it allows, the largest impedance, and contacts from 1 um before they touch, without which
    // bodies that just touch fall freely in the first step. It comes with 0.02 s, 0.9 to 0.95, and 0.
    const std::string impedance =
        choice.hard ? fmt::format("solref='{:.17g} 1' solimp='0.9999 0.9999 0.001'", 2 * setting.dt()) : "";
    const std::string effort =
        choice.solver == "PGS" ? fmt::format("iterations='{}' tolerance='0'", setting.sweeps) : "tolerance='1e-12'";
    text_ = fmt::format(
        "<mujoco><compiler angle='radian'/><size njmax='3000' nconmax='1000'/>"
        "<option timestep='{:.17g}' gravity='{}' solver='{}' {} integrator='{}' cone='elliptic'/>"
        "<default><geom condim='3' friction='{:.17g} 0 0' margin='{}' {}/><equality {}/></default><worldbody>",
        setting.dt(), text(world.gravity), choice.solver, effort, choice.integrator, world.bodies.back().friction,
        choice.hard ? "1e-6" : "0", impedance, impedance);
    for (const Body& body : world.bodies)
      if (pin_of(body) == nullptr || pin_of(body)->a == the_world) add(body, Vec3::Zero(), Quat::Identity());
    text_ += "</worldbody>";
    if (choice.connect) connect(motion.pins);
    text_ += "</mujoco>";
  }
  const std::string& operator()() const { return text_; }

 private:
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
      text_ += fmt::format("<body name='b{}' pos='{}' quat='{}'><geom type='plane' size='0 0 1'/></body>", body.index,
                           text(at), text(up));
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
      ids_.push_back(mj_name2id(model_.get(), mjOBJ_BODY, fmt::format("b{}", body.index).c_str()));
      const int joint = model_->body_jntadr[ids_.back()];
      if (joint < 0 || model_->jnt_type[joint] != mjJNT_FREE) continue;  // what is pinned begins at rest
      // Of a free joint: the velocity in world axes, the angular velocity in those of the body.
      Eigen::Map<Eigen::Matrix<double, 6, 1>> velocity(data_->qvel + model_->jnt_dofadr[joint]);
      velocity << body.velocity.cast<double>(), (body.orientation.conjugate() * body.angular_velocity).cast<double>();
    }
  }

  void substep() override {
    mj_step(model_.get(), data_.get());
    moved_ = true;
    row_solves_ += static_cast<double>(data_->nefc) * data_->solver_iter;
    if (const char* lost = lost_by(*data_)) throw InvalidInput(lost);
  }
  Eigen::Vector3d place(std::size_t body) const override {
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
  std::vector<int> ids_;
  mutable bool moved_ = true;
  double row_solves_ = 0;
};

Method method(const std::string& name, const std::string& title, const Choice& choice, bool only_pins = false) {
  return {.name = name,
          .title = title,
          .plays =
              [only_pins](const Motion& motion) {
                World world;
                motion.fill(world);  // MuJoCo has no restitution
                return world.bodies.back().restitution == 0 && (!only_pins || !motion.pins.empty());
              },
          .begin = [choice](const Motion& motion, const Setting& setting) -> std::unique_ptr<Player> {
            return std::make_unique<Mujoco>(motion, setting, choice);
          },
          .sweeps = choice.solver == "PGS"};
}

}  // namespace

std::vector<Method> peer_methods() {
  return {method("mujoco", "MuJoCo, hard", {}), method("mujoco-default", "MuJoCo, as it comes", {.hard = false}),
          method("mujoco-pgs", "MuJoCo, hard, sweeps", {.solver = "PGS"}),
          method("mujoco-rk4", "MuJoCo, Runge and Kutta", {.integrator = "RK4"}, true),
          method("mujoco-connect", "MuJoCo, pins as constraints", {.connect = true}, true)};
}

std::string peer_version() {
  return fmt::format("MuJoCo {}, double; called by {}", mj_versionString(), built_by());
}

}  // namespace pushback
