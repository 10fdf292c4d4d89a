/// The settings of a half step.
#pragma once

#include <limits>

#include "pushback/common/basics/types.h"

namespace pushback {

struct HalfStepSettings {
  int substeps = 1;                                                                   ///< of each step
  Real tolerance = std::numeric_limits<Real>::digits > 24 ? Real(1e-8) : Real(2e-6);  ///< m or rad, the largest |C|
  int most_rounds = 20;        ///< of Newton's method, before a step is divided
  Real threshold = Real(0.1);  ///< m/s; slower contacts do not bounce
  int most_halvings = 8;       ///< before the step fails
  double most_work = 1e10;     ///< approximate multiplications in a step, before it fails
  /// Whether contacts are solved without a guess (chapter 17) if Newton's method fails from the guess. If not, the step fails.
  bool fall_back_to_full_solve = true;

  /// Throws InvalidInput if a setting cannot be used.
  void check() const;
};

}  // namespace pushback
