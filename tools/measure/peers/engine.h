/// Another engine that simulates one of our worlds. It plays motions, and hard cases as one of our solvers.
#pragma once

#include "pushback/common/world/step_solver.h"
#include "pushback/tools/measure/hard_cases/peers.h"
#include "pushback/tools/measure/study/play.h"

namespace pushback {

/// Sleeping and damping are off. Friction and restitution of pairs are combined as in our worlds.
class Engine : public Player {
 public:
  /// Sets position, orientation and velocities of the engine's body.
  virtual void put(const Body& body) = 0;
  /// Moves an immovable body from `now` to `then` in the next step.
  virtual void drive(const Body& now, const Body& then) = 0;
  /// Applies the force and torque of a movable body in the next step.
  virtual void push(const Body& body) = 0;
  /// Advances by h, s. Throws InvalidInput if the engine fails.
  virtual void step(double h) = 0;
  void steps(int count, double h) override {
    for (int i = 0; i < count; ++i) step(h);
  }
};

using BeginEngine = std::unique_ptr<Engine>(const World& world, const PeerSetting& setting);

/// The error "not possible: ODE has no cone limit".
InvalidInput not_had(const std::string& what);

/// Throws not_had if the body has a feature that is not passed to engines in hard cases, which are skins, groups and conveying surfaces.
void check_plain(const Body& body);

/// Whether the body is immovable and moves at its velocity. A conveyor's velocity moves only its surface.
inline bool is_driven(const Body& body) {
  return !body.movable() && !body.conveys && (!body.velocity.isZero(0) || !body.angular_velocity.isZero(0));
}

/// `whole_step` passes the world to the engine. Changes by others since the latest step are written into the engine. If more than
/// positions and velocities have changed, the engine is built again. After the step our collision detection finds the contacts, so that
/// an overlap means the same for every engine. Their impulses are 0, because the engine's impulses are not read.
class EngineSolver : public StepSolver {
 public:
  EngineSolver(BeginEngine* begin, PeerSetting setting) : begin_(begin), setting_(std::move(setting)) {}
  /// A copy starts without an engine, because an engine cannot be copied.
  EngineSolver(const EngineSolver& other) : StepSolver(other), begin_(other.begin_), setting_(other.setting_) {}
  EngineSolver(EngineSolver&&) = default;
  EngineSolver& operator=(const EngineSolver&) = delete;

  Plan plan(Real) const override { return {.detections = setting_.substeps, .substeps = setting_.own_substeps}; }
  bool supports_joints() const override { return true; }
  /// Always throws, because an engine finds contacts itself and cannot take ours.
  void check(World& world, Real h) override;
  void solve(World& world, Real h, int /*sweeps*/) override { check(world, h); }
  void whole_step(World& world, Real dt, int sweeps) override;

 private:
  void hand_over(const World& world);
  void substep(World& world, Real h);

  BeginEngine* begin_;
  PeerSetting setting_;
  std::unique_ptr<Engine> engine_;
  std::vector<Body> left_;     // the bodies after the latest step
  std::vector<Joint> joints_;  // the joints with which the engine was built
  std::vector<bool> driven_;   // for each body, whether it was driven then
  Vec3 gravity_ = Vec3::Zero();
};

}  // namespace pushback
