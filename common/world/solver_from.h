/// A StepSolver made from a class without virtual functions.
#pragma once

#include "pushback/common/world/step_solver.h"

namespace pushback {

/// `Functions` has the functions of StepSolver, but needs no base class. Code that knows the type calls them directly, and World::step
/// calls them through this class. `integrate_positions` may be missing, as in solvers that leave the motion to the step. If another
/// function is missing or has a different signature, this class does not compile.
///
///   using HalfStep = SolverFrom<HalfStepIntegrator>;
template <class Functions>
class SolverFrom : public StepSolver, public Functions {
 public:
  Plan plan(Real dt) const override { return Functions::plan(dt); }
  bool supports_joints() const override { return Functions::supports_joints(); }
  void check(World& world, Real h) override { Functions::check(world, h); }
  void after_detection(World& world, Real h) override { Functions::after_detection(world, h); }
  void solve(World& world, Real h, int sweeps) override { Functions::solve(world, h, sweeps); }
  void integrate_positions(World& world, Real h) override {
    if constexpr (requires { this->Functions::integrate_positions(world, h); })
      Functions::integrate_positions(world, h);
    else StepSolver::integrate_positions(world, h);
  }
  void after_move(World& world, Real h) override { Functions::after_move(world, h); }
  void end_detection(World& world) override { Functions::end_detection(world); }
  SolveStats stats() const override { return Functions::stats(); }
};

}  // namespace pushback
