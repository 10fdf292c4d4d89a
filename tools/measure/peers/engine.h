/// Another engine with a world of ours in it, which plays motions, and hard cases as a solver of ours.
#pragma once

#include "pushback/common/world/step_solver.h"
#include "pushback/tools/measure/hard_cases/peers.h"
#include "pushback/tools/measure/study/play.h"

namespace pushback {

/// Sleeping and damping are off; a pair rubs and bounces as a pair of ours does.
class Engine : public Player {
 public:
  /// The body's position, orientation and velocities become the engine's.
  virtual void put(const Body& body) = 0;
  /// An immovable body that moves: in the next step it goes from `now` to `then`.
  virtual void drive(const Body& now, const Body& then) = 0;
  /// The force and torque of a movable body act in the next step.
  virtual void push(const Body& body) = 0;
  /// Moves on by h, s. Throws InvalidInput where the engine gives up.
  virtual void step(double h) = 0;
  void steps(int count, double h) override {
    for (int i = 0; i < count; ++i) step(h);
  }
};

using BeginEngine = std::unique_ptr<Engine>(const World& world, const PeerSetting& setting);

/// "not possible: ODE has no cone limit"
InvalidInput not_had(const std::string& what);

/// Throws not_had where the body has what no engine is told of in a hard case: a skin, groups, a surface that conveys.
void check_plain(const Body& body);

/// An immovable body whose velocity moves it; that of a conveyor moves its surface alone.
inline bool is_driven(const Body& body) {
  return !body.movable() && !body.conveys && (!body.velocity.isZero(0) || !body.angular_velocity.isZero(0));
}

/// A whole step hands the world to the engine. What others have changed since is written into it; where that is more than
/// positions and velocities, the engine is built again. Our collision detection finds the contacts after the step, so that an overlap
/// means the same under every engine. Their impulses are 0, because the engine's impulses are not read.
class EngineSolver : public StepSolver {
 public:
  EngineSolver(BeginEngine* begin, PeerSetting setting) : begin_(begin), setting_(std::move(setting)) {}
  /// A copy begins anew: an engine cannot be copied.
  EngineSolver(const EngineSolver& other) : StepSolver(other), begin_(other.begin_), setting_(other.setting_) {}
  EngineSolver(EngineSolver&&) = default;
  EngineSolver& operator=(const EngineSolver&) = delete;

  Plan plan(Real) const override { return {.detections = setting_.substeps, .substeps = setting_.own_substeps}; }
  bool supports_joints() const override { return true; }
  /// Call by call: throws, as an engine finds contacts by itself and cannot be given any.
  void check(World& world, Real h) override;
  void solve(World& world, Real h, int /*sweeps*/) override { check(world, h); }
  void whole_step(World& world, Real dt, int sweeps) override;

 private:
  void hand_over(const World& world);
  void substep(World& world, Real h);

  BeginEngine* begin_;
  PeerSetting setting_;
  std::unique_ptr<Engine> engine_;
  std::vector<Body> left_;     // as they were left after the latest step
  std::vector<Joint> joints_;  // that the engine was built with
  std::vector<bool> driven_;   // of its bodies: which were driven then
  Vec3 gravity_ = Vec3::Zero();
};

}  // namespace pushback
