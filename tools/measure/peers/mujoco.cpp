/// MuJoCo plays motions.
#include "pushback/tools/measure/peers/mujoco.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "pushback/tools/measure/peers/peer.h"
#include "pushback/tools/measure/study/every_motion.h"

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

/// Bodies that rub and bounce alike: those of a motion do.
MujocoChoice choice_of(const Choice& choice, const Setting& setting, const World& world) {
  MujocoChoice made{
      .options = fmt::format(
          "solver='{}' integrator='{}' cone='elliptic' {} {}", choice.solver, choice.integrator,
          choice.solver == "PGS" ? fmt::format("iterations='{}' tolerance='0'", setting.sweeps) : "tolerance='1e-12'",
          choice.noslip ? "impratio='10' noslip_iterations='10'" : ""),
      .hard = choice.hard,
      // Without it bodies that just touch fall freely in the first step.
      .margin = choice.hard ? 1e-6 : 0,
      .trees = !choice.connect,
      .spins = true,
      .planes_of_world = true};
  if (choice.bounces) {
    // Of a spring that bounces, 1/s. A bounce is of pi / rate, and its restitution off by some rate * dt: both fall with dt.
    const double rate = std::min(30.0 * setting.substeps, 120 * std::sqrt(setting.substeps));
    made.spring = {-rate * rate, -2 * damping_of(static_cast<double>(world.bodies.back().restitution)) * rate};
  }
  return made;
}

class PlaysMotion : public PlayerInSubsteps {
 public:
  PlaysMotion(const Motion& motion, const Setting& setting, const Choice& choice)
      : h_(setting.dt()), counts_rows_(choice.solver == "PGS") {
    World world;
    motion.begin(world);
    mujoco_.emplace(world, choice_of(choice, setting, world));
  }
  void substep() override { mujoco_->step(h_); }
  Eigen::Vector3d place(std::size_t body) const override { return mujoco_->place(body); }
  std::optional<double> row_solves() const override {
    if (!counts_rows_) return {};
    return mujoco_->row_solves();
  }

 private:
  double h_;
  bool counts_rows_;
  std::optional<Mujoco> mujoco_;
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
            return std::make_unique<PlaysMotion>(motion, setting, choice);
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
