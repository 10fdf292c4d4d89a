/// Feeds the overlap back as a target speed that removes the fraction beta of the overlap in one step.
#pragma once

#include "pushback/chapters/02_clamping/clamping.h"
#include "pushback/common/basics/input.h"

namespace pushback {

/// b = (beta / h) C,   C = -depth
struct Baumgarte : Effect {
  Real beta = Real(0.2);  ///< 0 ... 1: the fraction of the overlap that one step removes

  void check(StepContext&) { require_not_negative("beta", beta); }
  void build(StepContext& step) {
    for (std::size_t i = 0; i < step.contacts.size(); ++i) {
      Row& normal = step.rows[i];
      normal.bias = std::min(normal.bias, beta / step.dt * normal.separation);
    }
  }
};

}  // namespace pushback
