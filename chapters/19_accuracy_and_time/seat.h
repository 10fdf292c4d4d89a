/// A depth to rest at, however small.
#pragma once

#include "pushback/chapters/04_slop/slop.h"

namespace pushback {

/// In the place of Slop, after Baumgarte in the list.   C -> C + seat, and where that is above 0: b = (beta / h) C
///
/// What is solved exactly rests at a depth of 0, and rounding decides which of its contacts are there in the next step. So let
/// it sink, at the rate at which Baumgarte would lift it: b allows an approach of C beta / h. Slop leaves alone what is less
/// deep, and what is not, it stops there; both need a slop that outlasts a step's fall, g h^2. A seat does not.
struct Seat : Effect {
  Real seat = Real(1e-6);  ///< m
  Real beta = Real(0.2);   ///< of 0 ... 1: how much of what is missing one step sinks

  void check(StepContext&) {
    require_not_negative("seat", seat);
    require_between("beta", beta, 0, 1);
  }
  void adjust_separation(StepContext& step) {
    for (std::size_t i = 0; i < step.contacts.size(); ++i) step.rows[i].separation += seat;
  }
  void build(StepContext& step) {
    for (std::size_t i = 0; i < step.contacts.size(); ++i) {
      Row& normal = step.rows[i];
      if (normal.separation > 0) normal.bias = beta / step.dt * normal.separation;
    }
  }
};

}  // namespace pushback
