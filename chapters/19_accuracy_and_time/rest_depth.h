/// A depth at which bodies rest, which can be very small.
#pragma once

#include "pushback/chapters/04_slop/slop.h"

namespace pushback {

/// Replaces Slop, after Baumgarte in the list.   C -> C + rest_depth, and if that is above 0: b = (beta / h) C
///
/// An exact solution lets a body rest at a depth of 0, where rounding decides which of its contacts exist in the next step. A rest
/// depth lets the body sink, at the rate at which Baumgarte would lift it: b allows an approach speed of C beta / h. Slop does not
/// change a smaller depth and stops a larger one at the slop, so it has to exceed the fall in one step, g h^2. A rest depth does not
/// have to.
struct RestDepth : Effect {
  Real rest_depth = Real(1e-6);  ///< m
  Real beta = Real(0.2);         ///< 0 ... 1: the fraction of the missing depth by which a body sinks in one step

  void check(StepContext&) {
    require_not_negative("rest_depth", rest_depth);
    require_between("beta", beta, 0, 1);
  }
  void adjust_separation(StepContext& step) {
    for (std::size_t i = 0; i < step.contacts.size(); ++i) step.rows[i].separation += rest_depth;
  }
  void build(StepContext& step) {
    for (std::size_t i = 0; i < step.contacts.size(); ++i) {
      Row& normal = step.rows[i];
      if (normal.separation > 0) normal.bias = beta / step.dt * normal.separation;
    }
  }
};

}  // namespace pushback
