/// Leave a little overlap alone, so that contacts survive from step to step.
#pragma once

#include "chapters/03_baumgarte/baumgarte.h"

namespace pushback {

/// C -> min(0, C + slop).   In `touch`, so that whatever makes a bias of C in `build` finds it done.
struct Slop : Effect {
  Real slop = Real(0.005);  ///< m

  void touch(const Contacts& contacts, Rows& rows) {
    require_not_negative("slop", slop);
    for (std::size_t i = 0; i < contacts.size(); ++i) rows[i].separation = std::min(Real(0), rows[i].separation + slop);
  }
};

}  // namespace pushback
