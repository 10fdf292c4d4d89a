/// The settings of IslandSolver.
#pragma once

#include <limits>
#include <vector>

#include "pushback/engine/half_step/half_step.h"
#include "pushback/engine/islands/step_classifier.h"
#include "pushback/engine/islands/work_budget.h"

namespace pushback {

/// Numbers of half steps that are chosen outside the solver, see TwinSolver.
struct GivenSteps {
  std::vector<int> of_body;  ///< half steps in a step, by body; an island gets the largest number of its bodies
  int most_of_many = 0;      ///< the most half steps in a step of an island with many contacts, which pays for them
  int substeps = 0;          ///< of the bodies that get substeps; contact springs are as stiff as these allow
  Real tolerance = 0;        ///< m or rad, the largest |C|
  Real threshold = 0;        ///< m/s; slower contacts do not bounce and count as resting

  /// Throws InvalidInput if a value cannot be used for this number of bodies.
  void check(std::size_t bodies) const;
};

struct IslandSettings {
  HalfStepSettings contact_half_step{.substeps = 2, .most_work = 1e6};  ///< 1e6 multiplications take one or two ms
  HalfStepSettings joint_half_step = [] {
    HalfStepSettings s{.substeps = 4, .most_work = 1e6};
    // m g times the error of joints has to be well below the least allowed energy error. So the tolerance has to be well below
    // `energy` g h^2 / 2, which is 14 nm at 1/60 s.
    if constexpr (std::numeric_limits<Real>::digits > 24) s.tolerance /= 10;
    return s;
  }();
  ClassifierLimits limits;
  WorkBudgetSettings budget;
  Real energy = Real(1e-5);   ///< the allowed energy error of a step, as a fraction of T + m (h g)^2 / 2
  int most_half_steps = 128;  ///< in a step, for islands with joints
  /// If not empty, islands get these numbers of half steps, instead of the numbers that their energy error needs.
  GivenSteps given;

  /// Throws InvalidInput if a setting cannot be used.
  void check() const;
};

}  // namespace pushback
