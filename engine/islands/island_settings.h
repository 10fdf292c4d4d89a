/// The settings of IslandSolver.
#pragma once

#include <limits>

#include "pushback/engine/half_step/half_step.h"
#include "pushback/engine/islands/step_classifier.h"
#include "pushback/engine/islands/work_budget.h"

namespace pushback {

struct IslandSettings {
  HalfStepSettings contact_half_step{.substeps = 2, .most_work = 1e6};  ///< 1e6 multiplications take one or two ms
  HalfStepSettings joint_half_step = [] {
    HalfStepSettings s{.substeps = 4, .most_work = 1e6};
    // m g times the error of joints has to be well below the least energy error that is allowed: g h^2 / 2 of `energy`, 14 nm at 1/60 s.
    if constexpr (std::numeric_limits<Real>::digits > 24) s.tolerance /= 10;
    return s;
  }();
  ClassifierLimits limits;
  WorkBudgetSettings budget;
  Real energy = Real(1e-5);   ///< the energy error of a step that is allowed, as a fraction of T + m (h g)^2 / 2
  int most_half_steps = 128;  ///< of joints in a step

  /// m: the allowed position error after one second. If it is infinite, only the energy is checked.
  Real error = std::numeric_limits<Real>::infinity();
  int most_substeps = 128;  ///< in a step, with `error`
  int check_every = 4;      ///< steps: with `error`, how often a step is taken twice if nothing changes

  /// Throws InvalidInput if a setting cannot be used.
  void check() const;
};

}  // namespace pushback
