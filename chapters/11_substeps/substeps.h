/// Many substeps instead of many sweeps.
#pragma once

#include <concepts>
#include <utility>

#include "pushback/common/basics/input.h"
#include "pushback/common/world/step_solver.h"

namespace pushback {

/// A solver that divides each step into `count` substeps, with one sweep each. Every substep detects the contacts again.
/// Macklin et al., "Small Steps in Physics Simulation", SCA 2019.
template <std::derived_from<StepSolver> ContactSolver>
struct Substeps : ContactSolver {
  int count;
  int sweeps;  ///< in each substep

  explicit Substeps(ContactSolver solver = {}, int how_many = 32, int sweeps_of_each = 1)
      : ContactSolver(std::move(solver)), count(how_many), sweeps(sweeps_of_each) {}

  Plan plan(Real dt) const override {
    if (count < 1) throw InvalidInput(fmt::format("substeps is {}: a whole number, 1 or more, is needed", count));
    Plan plan = ContactSolver::plan(dt / static_cast<Real>(count));
    plan.detections *= count;
    plan.sweeps = sweeps;
    return plan;
  }
};

}  // namespace pushback
