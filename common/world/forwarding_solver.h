/// A solver that wraps another one.
#pragma once

#include "pushback/common/world/step_solver.h"

namespace pushback {

/// Forwards every call except `whole_step` to `inner`. A derived type overrides only the calls that it changes.
class ForwardingSolver : public StepSolver {
 public:
  Plan plan(Real dt) const override { return inner().plan(dt); }
  bool holds_joints() const override { return inner().holds_joints(); }
  void check(World& world, Real h) override { inner().check(world, h); }
  void detected(World& world, Real h) override { inner().detected(world, h); }
  void solve(World& world, Real h, int sweeps) override { inner().solve(world, h, sweeps); }
  void integrate_positions(World& world, Real h) override { inner().integrate_positions(world, h); }
  void moved(World& world, Real h) override { inner().moved(world, h); }
  void done(World& world) override { inner().done(world); }
  Solved solved() const override { return inner().solved(); }

 protected:
  virtual StepSolver& inner() = 0;
  virtual const StepSolver& inner() const = 0;
};

}  // namespace pushback
