/// The overlap is fed back as a wanted speed, at which the part beta of it is gone after one step.
#pragma once

#include "pushback/chapters/02_clamping/clamping.h"
#include "pushback/common/basics/input.h"

namespace pushback {

/// b = (beta / h) C,   C = -depth
struct Baumgarte : Effect {
  Real beta = Real(0.2);  ///< of 0 ... 1: how much of the overlap one step takes away

  void check(StepContext&) { require_not_negative("beta", beta); }
  void build(StepContext& step) {
    for (std::size_t i = 0; i < step.contacts.size(); ++i) {
      Row& normal = step.rows[i];
      normal.bias = std::min(normal.bias, beta / step.dt * normal.separation);
    }
  }
};

}  // namespace pushback
