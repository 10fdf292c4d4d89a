/// MuJoCo, in double: Debian's 2.2.2, or the one that its own CMake has installed.
#include <fmt/format.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <numbers>
#include <stdexcept>

#include "pushback/common/basics/input.h"
#include "pushback/tools/measure/peers/peer.h"

namespace pushback {

namespace {

/// 3.11 has surfaces that convey, motors within a step, and room for as many rows as there are.
constexpr bool is_current = mjVERSION_HEADER >= 3'011'000;

struct ReleaseMujoco {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
  void operator()(mjData* data) const { mj_deleteData(data); }
};
using MujocoModel = std::unique_ptr<mjModel, ReleaseMujoco>;
using MujocoData = std::unique_ptr<mjData, ReleaseMujoco>;

/// What its settings differ in. As it comes: none of these.
struct MujocoChoice {
  /// Attributes of MJCF's <option>: the method, its effort, the cone.
  std::string options;
  /// As hard as it goes: contacts and constraints have the least time constant that MuJoCo allows, two steps, and nearly the largest
  /// impedance. It comes with 0.02 s, and 0.9 to 0.95.
  bool hard = false;
  bool sweeps = false;  ///< rows are swept, and counted
  double margin = 0;    ///< m: contacts act so far ahead
  /// The spring and damper of a contact that bounces, MJCF's two negative numbers; else a restitution is not had.
  std::optional<std::array<double, 2>> spring = {};
  bool trees = true;  ///< what hangs on another body is its child in a tree; else every joint is a constraint
  /// What hangs by a ball begins with its angular velocity, where the other body has none; else that is not had. Of several planes that
  /// stay, each is a part of the world, not of a body of its own: with two such bodies and few others, MuJoCo 2.2.2 ends with "Broadphase
  /// buffer full", as each is a pair with every body, also with the other. And all that is asked for is read back, which rounds turns.
  bool of_motion = false;
};

std::string text(const Vec3& v) {
  return fmt::format("{:.17g} {:.17g} {:.17g}", v.x(), v.y(), v.z());
}

std::string text(const Quat& q) {
  return fmt::format("{:.17g} {:.17g} {:.17g} {:.17g}", q.w(), q.x(), q.y(), q.z());
}

MujocoModel model_of(const std::string& mjcf) {
  mju_user_warning = [](const char*) {};  // its own writes a file; lost_by asks
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
#if mjVERSION_HEADER >= 314
  mj_addBufferVFS(files.get(), "world.xml", mjcf.data(), static_cast<int>(mjcf.size()));
#else
  mj_makeEmptyFileVFS(files.get(), "world.xml", static_cast<int>(mjcf.size()));
  std::memcpy(files->filedata[0], mjcf.data(), mjcf.size());
#endif
  std::array<char, 1000> problem{};
  MujocoModel model(mj_loadXML("world.xml", files.get(), problem.data(), static_cast<int>(problem.size())));
  mj_deleteVFS(files.get());
  if (model == nullptr) throw std::runtime_error(fmt::format("MuJoCo: {}", problem.data()));
  return model;
}

/// In the latest step. Rows of all islands are swept together.
int sweeps_of(const mjData& data) {
#if mjVERSION_HEADER >= 314
  return data.solver_niter[0];
#else
  return data.solver_iter;
#endif
}

/// What went wrong so far; null: nothing. MuJoCo begins anew by itself where a state is no number.
const char* lost_by(const mjData& data) {
  for (const int lost : {mjWARN_BADQPOS, mjWARN_BADQVEL, mjWARN_BADQACC, mjWARN_CONTACTFULL, mjWARN_CNSTRFULL})
    if (data.warning[lost].number > 0) return mju_warningText(lost, 0);
  return nullptr;
}

/// A world as MJCF. Bodies are called b0, b1 ... by their index. What hangs on another body by a joint is its child in a tree, held
/// by coordinates; a joint that closes a loop is an equality.
class Mjcf {
 public:
  Mjcf(const World& world, const MujocoChoice& choice) : world_(world), of_motion_(choice.of_motion) {
    std::vector<HeldPair> pairs =
        is_current ? held_pairs(world, {JointShape::ball_and_socket, JointShape::hinge, JointShape::angle_limits,
                                        JointShape::motor})
                   : held_pairs(world, {JointShape::ball_and_socket, JointShape::hinge, JointShape::angle_limits});
    for (HeldPair& pair : pairs) {
      const bool hangs = choice.trees && hang(pair.joint->a, pair.joint->b);
      if (!hangs && (pair.turn || pair.motor)) throw not_had("limits and motors of a joint that closes a loop");
      (hangs ? parents_ : loops_).push_back(std::move(pair));
    }
    const bool motors = std::ranges::any_of(parents_, [](const HeldPair& pair) { return pair.motor.has_value(); });
    text_ = fmt::format(
        "<mujoco><compiler angle='radian'/><size {}/>"
        "<option gravity='{}' {} {}><flag multiccd='enable'/></option><default><geom margin='{}'/></default>",
        room(), text(world.gravity), choice.options, motors ? "integrator='implicitfast'" : "", choice.margin);
    for (const Body& body : world.bodies) asset(body);
    text_ += "<worldbody>";
    for (const Body& body : world.bodies)
      if (held_by(body.index) == nullptr || held_by(body.index)->joint->a == the_world)
        add(body, Vec3::Zero(), Quat::Identity());
    text_ += "</worldbody>";
    close_loops();
    drive_motors();
    contacts_of_pairs();
    text_ += "</mujoco>";
  }
  const std::string& operator()() const { return text_; }

 private:
  /// 2.2.2 has as many contacts as there may be, or as fit into the 2 GB that it has room for: 12 bytes for each two rows, 24 for each
  /// row and velocity.
  std::string room() const {
    if (is_current) return "memory='2G'";
    const auto moving = std::ranges::count_if(world_.bodies, &Body::movable);
    constexpr double room = 1.4e9, rows = 4;
    const double b = 24 * rows * 6 * static_cast<double>(moving), a = 12 * rows * rows;
    const long contacts =
        std::min(200 + 16 * moving, static_cast<long>((std::sqrt(b * b + 4 * a * room) - b) / (2 * a)));
    return fmt::format("njmax='{}' nconmax='{}'", 4 * contacts + 6 * static_cast<long>(loops_.size()), contacts);
  }

  /// Whether b, which moves and hangs on nothing yet, is from now on a child of a.
  bool hang(int a, int b) {
    if (b == the_world || !world_.body(b).movable() || held_by(b) != nullptr) return false;
    for (const HeldPair* above = held_by(a); above != nullptr; above = held_by(above->joint->a))
      if (above->joint->a == b) return false;
    return a == the_world || a != b;
  }
  const HeldPair* held_by(int index) const {
    for (const HeldPair& held : parents_)
      if (held.joint->b == index) return &held;
    return nullptr;
  }

  void asset(const Body& body) {
    const auto* hull = std::get_if<Hull>(&body.shape);
    if (hull == nullptr) return;
    text_ += fmt::format("<asset><mesh name='m{}' vertex='", body.index);
    for (const Vec3& corner : hull->solid->corners) text_ += text(corner) + " ";
    text_ += "'/></asset>";
  }

  static std::string geom_of(const Body& body) {
    if (const auto* ball = std::get_if<Sphere>(&body.shape))
      return fmt::format("type='sphere' size='{:.17g}'", ball->radius);
    if (const auto* box = std::get_if<Box>(&body.shape))
      return fmt::format("type='box' size='{}'", text(box->half_extents));
    if (const auto* capsule = std::get_if<Capsule>(&body.shape))
      return fmt::format("type='capsule' size='{:.17g} {:.17g}' quat='{}'", capsule->radius, capsule->half_length,
                         text(Quat(Quat::FromTwoVectors(Vec3::UnitZ(), Vec3::UnitY()))));
    if (std::holds_alternative<Hull>(body.shape)) return fmt::format("type='mesh' mesh='m{}'", body.index);
    return fmt::format("type='plane' size='0 0 1' quat='{}'",
                       text(Quat(Quat::FromTwoVectors(Vec3::UnitZ(), std::get<HalfSpace>(body.shape).normal))));
  }
  static std::string surface_of(const Body& body) {
    if (!(body.friction > 0)) return "condim='1'";
    std::string belt;
    if (body.conveys) {  // in the axes of the geom
      const auto* below = std::get_if<HalfSpace>(&body.shape);
      const Quat turn =
          below ? Quat(body.orientation * Quat::FromTwoVectors(Vec3::UnitZ(), below->normal)) : body.orientation;
      belt = fmt::format("surfacevel='{} 0 0 0'", text(Vec3(turn.conjugate() * body.velocity)));
    }
    return fmt::format("condim='3' friction='{:.17g} 0 0' {}", body.friction, belt);
  }

  bool is_of_world(const Body& body) const {
    const auto stays = [](const Body& one) { return std::holds_alternative<HalfSpace>(one.shape) && !is_driven(one); };
    return of_motion_ && stays(body) && std::count_if(world_.bodies.begin(), world_.bodies.end(), stays) > 1;
  }

  /// `body` is the child. The angle of a hinge is that of b against a from where they stand.
  static std::string joint_of(const HeldPair& held, const Body& body) {
    const auto local = [&](const Vec3& v) { return text(Vec3(body.orientation.conjugate() * v)); };
    const std::string at = local(held.shape.anchor_b - body.position);
    if (held.shape.kind != JointShape::hinge) {
      if (held.turn) throw not_had("a twist limit: a range of its balls is of the whole turn");
      return fmt::format("<joint type='ball' pos='{}'/>", at);
    }
    std::string range;
    if (held.turn) {
      const JointShape turn = turned_to(*held.turn, held.shape.axis);
      range = fmt::format("limited='true' range='{:.17g} {:.17g}'", turn.low, turn.high);
    }
    return fmt::format("<joint name='j{}' type='hinge' pos='{}' axis='{}' {}/>", body.index, at, local(held.shape.axis),
                       range);
  }

  /// The body in the frame of the one that it hangs on, and in it those that hang on it.
  void add(const Body& body, const Vec3& from, const Quat& turn) {
    if (is_of_world(body)) {
      text_ += fmt::format("<geom name='g{}' pos='{}' {} {}/>", body.index, text(body.position), geom_of(body),
                           surface_of(body));
      return;
    }
    text_ += fmt::format("<body name='b{}' pos='{}' quat='{}' {}>", body.index,
                         text(Vec3(turn.conjugate() * (body.position - from))),
                         text(Quat(turn.conjugate() * body.orientation)), is_driven(body) ? "mocap='true'" : "");
    if (body.movable()) {
      const HeldPair* held = held_by(body.index);
      text_ += held == nullptr ? "<freejoint/>" : joint_of(*held, body);
      text_ += fmt::format("<inertial pos='0 0 0' mass='{:.17g}' diaginertia='{}'/>", 1 / body.inverse_mass,
                           text(Vec3(body.principal_inverse_inertia.cwiseInverse())));
    }
    text_ += fmt::format("<geom name='g{}' {} {}/>", body.index, geom_of(body), surface_of(body));
    for (const HeldPair& held : parents_)
      if (held.joint->a == body.index) add(world_.body(held.joint->b), body.position, body.orientation);
    text_ += "</body>";
  }

  /// A hinge has two points of its axis in common.
  void close_loops() {
    if (loops_.empty()) return;
    text_ += "<equality>";
    for (const HeldPair& held : loops_) {
      const bool hinge = held.shape.kind == JointShape::hinge;
      const int of = held.joint->a == the_world ? held.joint->b : held.joint->a,
                to = held.joint->a == the_world ? the_world : held.joint->b;
      const Vec3& anchor = held.joint->a == the_world ? held.shape.anchor_b : held.shape.anchor_a;
      const Body& body = world_.body(of);
      for (const Real along : {Real(-0.5), Real(0.5)}) {
        if (!hinge && along > 0) continue;
        const Vec3 at = anchor + (hinge ? along : 0) * held.shape.axis;
        text_ += fmt::format("<connect body1='b{}' {}anchor='{}'/>", of,
                             to == the_world ? "" : fmt::format("body2='b{}' ", to),
                             text(Vec3(body.orientation.conjugate() * (at - body.position))));
      }
    }
    text_ += "</equality>";
  }

  /// Brakes that run along: torque = kv (speed - w), within what the motor has. With kv so large the angle is that of the speed, as it
  /// is integrated implicitly.
  void drive_motors() {
    std::string motors;
    for (const HeldPair& held : parents_)
      if (held.motor)
        motors += fmt::format("<velocity joint='j{}' kv='1e6' forcelimited='true' forcerange='-{:.17g} {:.17g}'/>",
                              held.joint->b, held.motor->torque, held.motor->torque);
    if (!motors.empty()) text_ += "<actuator>" + motors + "</actuator>";
  }

  /// A pair has the larger of its two frictions, unless it is one of its own in the place of what is found for its bodies. Those that
  /// are joined do not touch.
  void contacts_of_pairs() {
    const JoinedPairs joined(world_.joints);
    std::string pairs;
    for (const Body& a : world_.bodies) {
      for (const Body& b : world_.bodies) {
        if (b.index <= a.index || (!a.movable() && !b.movable())) continue;
        const bool joint = joined.contain(a.index, b.index);
        if (joint || a.friction != b.friction)
          pairs += fmt::format("<exclude body1='b{}' body2='b{}'/>", a.index, b.index);
        if (!joint && a.friction != b.friction) {
          const Real mu = std::sqrt(a.friction * b.friction);
          pairs +=
              fmt::format("<pair geom1='g{}' geom2='g{}' {}/>", a.index, b.index,
                          mu > 0 ? fmt::format("condim='3' friction='{0:.17g} {0:.17g} 0 0 0'", mu) : "condim='1'");
        }
      }
    }
    if (!pairs.empty()) text_ += "<contact>" + pairs + "</contact>";
  }

  const World& world_;
  bool of_motion_;
  std::vector<HeldPair> parents_, loops_;
  std::string text_;
};

/// Of a free joint: the velocity in world axes, and the angular velocity, like that of a ball joint, in those of the body.
void set_velocity(mjtNum* velocity, const Body& body, bool free) {
  Eigen::Map<Eigen::Vector3d> moving(velocity), turning(velocity + (free ? 3 : 0));
  if (free) moving = body.velocity.cast<double>();
  turning = (body.orientation.conjugate() * body.angular_velocity).cast<double>();
}

class Mujoco : public Engine {
 public:
  Mujoco(const World& world, const MujocoChoice& choice) : choice_(choice) {
    for (const Body& body : world.bodies)
      if (body.restitution != 0 && !choice.spring) throw not_had("restitution");
    model_ = model_of(Mjcf(world, choice)());
    data_.reset(mj_makeData(model_.get()));
    for (const Body& body : world.bodies) {
      const int id = mj_name2id(model_.get(), mjOBJ_BODY, fmt::format("b{}", body.index).c_str());
      const int joint = id < 0 ? -1 : model_->body_jntadr[id];
      ids_.push_back(id);
      free_.push_back(joint >= 0 && model_->jnt_type[joint] == mjJNT_FREE ? joint : -1);
      if (free_.back() >= 0) {
        put(body);
      } else if (joint >= 0 && choice.of_motion && model_->jnt_type[joint] == mjJNT_BALL) {
        set_velocity(data_->qvel + model_->jnt_dofadr[joint], body, false);
      } else if (body.movable() && (!body.velocity.isZero(0) || !body.angular_velocity.isZero(0))) {
        throw not_had("a joined body that begins with a velocity");
      }
    }
    int motor = 0;  // in the order of the joints, which is that of the model
    for (const HeldPair& held : held_pairs(world))
      if (held.motor) data_->ctrl[motor++] = turned_to(*held.motor, held.shape.axis).speed;
    read_back();
  }

  void put(const Body& body) override {
    const int joint = free_[static_cast<std::size_t>(body.index)];
    if (joint < 0) {
      if (!body.movable() && model_->body_mocapid[ids_[static_cast<std::size_t>(body.index)]] >= 0) return;
      throw not_had("a joined body that is put elsewhere");
    }
    Eigen::Map<Eigen::Matrix<double, 7, 1>> place(data_->qpos + model_->jnt_qposadr[joint]);
    const Eigen::Quaterniond q = body.orientation.cast<double>();
    place << body.position.cast<double>(), q.w(), q.x(), q.y(), q.z();
    set_velocity(data_->qvel + model_->jnt_dofadr[joint], body, true);
  }

  void get(Body& body) const override {
    const int id = ids_[static_cast<std::size_t>(body.index)];
    const int joint = free_[static_cast<std::size_t>(body.index)];
    if (joint < 0 || choice_.of_motion) read_back();
    const mjtNum* q = joint >= 0 ? data_->qpos + model_->jnt_qposadr[joint] + 3 : data_->xquat + 4 * id;
    const mjtNum* at = joint >= 0 ? data_->qpos + model_->jnt_qposadr[joint] : data_->xipos + 3 * id;
    body.position = Eigen::Map<const Eigen::Vector3d>(at).cast<Real>();
    body.orientation = Quat(q[0], q[1], q[2], q[3]).normalized();
    if (joint >= 0) {
      const Eigen::Map<const Eigen::Matrix<double, 6, 1>> velocity(data_->qvel + model_->jnt_dofadr[joint]);
      body.velocity = velocity.head<3>().cast<Real>();
      body.angular_velocity = body.orientation * Vec3(velocity.tail<3>().cast<Real>());
      return;
    }
    std::array<mjtNum, 6> velocity{};  // the angular one comes first
    mj_objectVelocity(model_.get(), data_.get(), mjOBJ_BODY, id, velocity.data(), 0);
    body.angular_velocity = {velocity[0], velocity[1], velocity[2]};
    body.velocity = {velocity[3], velocity[4], velocity[5]};
  }

  /// A body that is moved by hand has a place, and no velocity that contacts would see.
  void drive(const Body&, const Body& then) override {
    const int at = model_->body_mocapid[ids_[static_cast<std::size_t>(then.index)]];
    Eigen::Map<Eigen::Vector3d>(data_->mocap_pos + 3 * at) = then.position.cast<double>();
    const Eigen::Quaterniond q = then.orientation.cast<double>();
    Eigen::Map<Eigen::Vector4d>(data_->mocap_quat + 4 * at) << q.w(), q.x(), q.y(), q.z();
  }

  void push(const Body& body) override {
    Eigen::Map<Eigen::Matrix<double, 6, 1>> force(data_->xfrc_applied + 6 * ids_[static_cast<std::size_t>(body.index)]);
    force << body.force.cast<double>(), body.torque.cast<double>();
  }
  void step(double h) override {
    if (model_->opt.timestep != h) take_steps_of(h);
    mj_step(model_.get(), data_.get());
    moved_ = true;
    row_solves_ += static_cast<double>(data_->nefc) * sweeps_of(*data_);
    if (const char* lost = lost_by(*data_)) throw InvalidInput(fmt::format("not finite, or too large: {}", lost));
  }

  /// Rows times iterations, in all steps, of sweeps.
  std::optional<double> row_solves() const override {
    if (!choice_.sweeps) return {};
    return row_solves_;
  }

 private:
  /// A step leaves the places and velocities of where it began.
  void read_back() const {
    if (!moved_) return;
    mj_kinematics(model_.get(), data_.get());
    mj_comPos(model_.get(), data_.get());
    mj_comVel(model_.get(), data_.get());
    moved_ = false;
  }

  void take_steps_of(double h) {
    model_->opt.timestep = h;
    if (!choice_.hard) return;
    const auto harden = [](mjtNum* solref, mjtNum* solimp, auto count, const std::array<double, 2>& reference) {
      for (auto i = count - count; i < count; ++i) {
        solref[mjNREF * i] = reference[0];
        solref[mjNREF * i + 1] = reference[1];
        solimp[mjNIMP * i] = solimp[mjNIMP * i + 1] = 0.9999;
      }
    };
    const std::array<double, 2> rigid{2 * h, 1}, contact = choice_.spring.value_or(rigid);
    harden(model_->geom_solref, model_->geom_solimp, model_->ngeom, contact);
    harden(model_->pair_solref, model_->pair_solimp, model_->npair, contact);
    harden(model_->eq_solref, model_->eq_solimp, model_->neq, rigid);
    harden(model_->jnt_solref, model_->jnt_solimp, model_->njnt, rigid);
  }

  MujocoChoice choice_;
  MujocoModel model_;
  MujocoData data_;
  std::vector<int> ids_;
  std::vector<int> free_;      // the free joint of each body; -1: it has none
  mutable bool moved_ = true;  // since it was read back
  double row_solves_ = 0;
};

/// What the methods differ in.
struct Choice {
  std::string solver = "Newton";
  std::string integrator = "Euler";
  bool hard = true;      ///< as hard as it goes; else as it comes
  bool bounces = false;  ///< contacts are springs and dampers that give the motion's restitution
  bool noslip = false;   ///< friction as stiff as its makers advise, and ten sweeps that take out the slip that is left
  bool connect = false;  ///< pins are constraints, not the joints of a tree
  std::string cone = "elliptic";
  std::string tolerance = "1e-12";  ///< of the improvement in an iteration; it comes with 1e-8
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

/// Bodies that rub and bounce alike: those of a motion do.
MujocoChoice choice_of(const Choice& choice, const Setting& setting, const World& world) {
  MujocoChoice made{.options = fmt::format(
                        "solver='{}' integrator='{}' cone='{}' {} {}", choice.solver, choice.integrator, choice.cone,
                        choice.solver == "PGS" ? fmt::format("iterations='{}' tolerance='0'", setting.sweeps)
                                               : fmt::format("tolerance='{}'", choice.tolerance),
                        choice.noslip ? "impratio='10' noslip_iterations='10'" : ""),
                    .hard = choice.hard,
                    .sweeps = choice.solver == "PGS",
                    // Without it bodies that just touch fall freely in the first step.
                    .margin = choice.hard ? 1e-6 : 0,
                    .trees = !choice.connect,
                    .of_motion = true};
  if (choice.bounces) {
    // Of a spring that bounces, 1/s. A bounce is of pi / rate, and its restitution off by some rate * dt: both fall with dt.
    const double rate = std::min(30.0 * setting.substeps, 120 * std::sqrt(setting.substeps));
    made.spring = {-rate * rate, -2 * damping_of(static_cast<double>(world.bodies.back().restitution)) * rate};
  }
  return made;
}

/// What its contacts must be able to do, and what only some methods are for.
enum class For { all, pins, friction };

Method method(const std::string& name, const std::string& title, const Choice& choice, For what = For::all) {
  return {.name = name,
          .title = title,
          .plays =
              [what, bounces = choice.bounces, sparse = choice.solver == "CG"](const Motion& motion) {
                World world;
                motion.fill(world);  // MuJoCo has no restitution, but springs
                return (world.bodies.back().restitution > 0) == bounces && (is_current || !has_conveyor(motion)) &&
                       // Among a thousand bodies a step by a matrix takes minutes; 2.2.2 has no room for the rows.
                       (few_bodies(motion) || (is_current && sparse)) && (what != For::pins || !motion.pins.empty()) &&
                       (what != For::friction || has_contacts(motion));
              },
          .begin =
              [choice](const World& world, const Setting& setting) {
                return std::make_unique<Mujoco>(world, choice_of(choice, setting, world));
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
          method("mujoco-rk4", "MuJoCo, Runge and Kutta", {.integrator = "RK4"}),
          method("mujoco-tolerance", "MuJoCo, hard, to its own tolerance", {.tolerance = "1e-8"}),
          method("mujoco-pyramid", "MuJoCo, hard, friction as a pyramid, to its own tolerance",
                 {.cone = "pyramidal", .tolerance = "1e-8"}),
          method("mujoco-cg", "MuJoCo, hard, conjugate gradients", {.solver = "CG", .tolerance = "1e-8"}),
          method("mujoco-connect", "MuJoCo, pins as constraints", {.connect = true}, For::pins)};
}

std::unique_ptr<Engine> begin_engine(const World& world, const PeerSetting& setting) {
  return std::make_unique<Mujoco>(world, MujocoChoice{.options = setting.options, .hard = setting.tuned});
}

std::string peer_version() {
  return fmt::format("MuJoCo {}, double, {}; called by {}", mj_versionString(), PUSHBACK_ENGINE_IS, built_by());
}

}  // namespace pushback
