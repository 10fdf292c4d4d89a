/// The settings of IslandSolver.
#pragma once

#include <limits>
#include <vector>

#include "pushback/engine/half_step/half_step.h"
#include "pushback/engine/islands/step_classifier.h"
#include "pushback/engine/islands/work_budget.h"

namespace pushback {

/// Half steps that something outside the solver has chosen: see TwinSolver.
struct GivenSteps {
  std::vector<int> of_body;  ///< in a step; an island gets the largest number of its bodies
  int most_of_many = 0;      ///< in a step, of islands with many contacts, which have to pay for them
  int substeps = 0;          ///< in a step of the bodies that get substeps, on springs as stiff as these hold
  Real tolerance = 0;        ///< m or rad: the largest |C|
  Real threshold = 0;        ///< m/s: slower contacts do not bounce, and are at rest

  /// Throws InvalidInput if so many bodies cannot be moved by them.
  void check(std::size_t bodies) const;
};

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
  /// If there are any, islands get these half steps, instead of as many as their energy needs.
  GivenSteps given;

  /// Throws InvalidInput if a setting cannot be used.
  void check() const;
};

}  // namespace pushback
