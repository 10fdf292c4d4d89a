/// MuJoCo with a world of ours in it, for motions and for hard cases. It computes in double.
#pragma once

#include <mujoco/mujoco.h>

#include <array>
#include <memory>
#include <optional>

#include "pushback/tools/measure/peers/engine.h"

namespace pushback {

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
  double margin = 0;  ///< m: contacts act so far ahead
  /// The spring and damper of a contact that bounces, MJCF's two negative numbers; else a restitution is not had.
  std::optional<std::array<double, 2>> spring = {};
  bool trees = true;  ///< what hangs on another body is its child in a tree; else every joint is a constraint
  /// What hangs by a ball begins with its angular velocity, where the other body has none; else that is not had.
  bool spins = false;
  /// Of several planes that stay, each is a part of the world, not of a body of its own: with two such bodies and few others, MuJoCo
  /// 2.2.2 ends with "Broadphase buffer full", as each is a pair with every body, also with the other.
  bool planes_of_world = false;
};

class Mujoco : public Engine {
 public:
  /// Throws not_had.
  Mujoco(const World& world, const MujocoChoice& choice);

  void put(const Body& body) override;
  void get(Body& body) const override;
  void drive(const Body& now, const Body& then) override;
  void step(const std::vector<Body>& bodies, Real h) override;
  /// Moves on by h, s, with gravity alone. Leaves the places of bodies in trees as they were. Throws InvalidInput where MuJoCo gives up.
  void step(double h);
  /// Of the centre of mass of the body with this index, m.
  Eigen::Vector3d place(std::size_t body) const;
  /// Rows times iterations, in all steps.
  double row_solves() const { return row_solves_; }

 private:
  void read_back() const;
  void take_steps_of(double h);

  MujocoChoice choice_;
  MujocoModel model_;
  MujocoData data_;
  std::vector<int> ids_;
  std::vector<int> free_;               // the free joint of each body; -1: it has none
  std::vector<Eigen::Vector3d> begin_;  // where the bodies were at first
  bool in_tree_ = false;                // whether any hangs on another
  mutable bool moved_ = true;           // a step leaves the places of where it began
  double row_solves_ = 0;
};

}  // namespace pushback
