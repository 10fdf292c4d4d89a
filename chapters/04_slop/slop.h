/// Leaves a small overlap uncorrected, so that contacts persist from step to step.
#pragma once

#include "pushback/chapters/03_baumgarte/baumgarte.h"

namespace pushback {

/// C -> min(0, C + slop).   In `adjust_separation`, the hook before `build`, in which effects compute their bias from C.
struct Slop : Effect {
  Real slop = Real(0.005);  ///< m

  void check(StepContext&) { require_not_negative("slop", slop); }
  void adjust_separation(StepContext& step) {
    for (std::size_t i = 0; i < step.contacts.size(); ++i) {
      Row& normal = step.rows[i];
      normal.separation = std::min(Real(0), normal.separation + slop);
    }
  }
};

}  // namespace pushback
