/// Feed the overlap back as a wanted speed: the part beta of it should be gone after one step.
#pragma once

#include "chapters/02_clamping/clamping.h"
#include "common/input.h"

namespace pushback {

/// b = (beta / h) C,   C = -depth
struct Baumgarte : Effect {
  Real beta = Real(0.2);  ///< of 0 ... 1: how much of the overlap one step takes away

  void build(const Contacts& contacts, Rows& rows, Real dt) {
    require_not_negative("beta", beta);
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      rows[i].bias = std::min(rows[i].bias, beta / dt * rows[i].separation);
    }
  }
};

}  // namespace pushback
