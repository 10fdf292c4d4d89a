/// A depth to rest at, however small.
#pragma once

#include "chapters/04_slop/slop.h"

namespace pushback {

/// In the place of Slop, after Baumgarte in the list.   C -> C + seat, and where that is above 0: b = (beta / h) C
///
/// What is solved exactly rests at a depth of 0, and rounding decides which of its contacts are there in the next step. So let
/// it sink, at the rate at which Baumgarte would lift it: b allows an approach of C beta / h. Slop leaves alone what is less
/// deep, and what is not, it stops there; both need a slop that outlasts a step's fall, g h^2. A seat does not.
struct Seat : Effect {
  Real seat = Real(1e-6);  ///< m
  Real beta = Real(0.2);   ///< of 0 ... 1: how much of what is missing one step sinks

  void touch(const Contacts& contacts, Rows& rows) {
    require_not_negative("seat", seat);
    require_between("beta", beta, 0, 1);
    for (std::size_t i = 0; i < contacts.size(); ++i) rows[i].separation += seat;
  }
  void build(const Contacts& contacts, Rows& rows, Real dt) {
    for (std::size_t i = 0; i < contacts.size(); ++i)
      if (rows[i].separation > 0) rows[i].bias = beta / dt * rows[i].separation;
  }
};

}  // namespace pushback
