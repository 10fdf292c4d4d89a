/// Another engine as a solver of ours.
#pragma once

#include <functional>

#include "pushback/common/world/step_solver.h"
#include "pushback/tools/measure/peers/engine.h"

namespace pushback {

/// A whole step hands the world to the engine. What others have changed since is written into it; where that is more than
/// positions and velocities, the engine begins anew. Contacts are found by ours, where bodies are after the step, so that an
/// overlap means the same whoever moved them; of what the engine pushed there they know nothing: their impulses are 0.
class EngineSolver : public StepSolver {
 public:
  EngineSolver(BeginEngine* begin, PeerSetting setting) : begin_(begin), setting_(std::move(setting)) {}
  /// A copy begins anew: an engine cannot be copied.
  EngineSolver(const EngineSolver& other) : StepSolver(other), begin_(other.begin_), setting_(other.setting_) {}
  EngineSolver(EngineSolver&&) = default;
  EngineSolver& operator=(const EngineSolver&) = delete;

  Plan plan(Real) const override { return {.detections = setting_.substeps, .substeps = setting_.own_substeps}; }
  bool holds_joints() const override { return true; }
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
