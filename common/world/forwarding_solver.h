/// A solver that wraps another one.
#pragma once

#include "pushback/common/world/step_solver.h"

namespace pushback {

/// Forwards every call except `whole_step` to `inner`. A derived type overrides only the calls that it changes.
class ForwardingSolver : public StepSolver {
 public:
  Plan plan(Real dt) const override { return inner().plan(dt); }
  bool supports_joints() const override { return inner().supports_joints(); }
  void check(World& world, Real h) override { inner().check(world, h); }
  void after_detection(World& world, Real h) override { inner().after_detection(world, h); }
  void solve(World& world, Real h, int sweeps) override { inner().solve(world, h, sweeps); }
  void integrate_positions(World& world, Real h) override { inner().integrate_positions(world, h); }
  void after_move(World& world, Real h) override { inner().after_move(world, h); }
  void end_detection(World& world) override { inner().end_detection(world); }
  SolveStats stats() const override { return inner().stats(); }

 protected:
  virtual StepSolver& inner() = 0;
  virtual const StepSolver& inner() const = 0;
};

}  // namespace pushback
