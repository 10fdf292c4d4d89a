/// A contact pushes and never pulls: the impulse that it has accumulated over the sweeps is not negative.
#pragma once

#include "pushback/chapters/01_velocity_constraint/solver.h"

namespace pushback {

/// sum(lambda) in [0, inf)
struct Clamping : Effect {
  void build(StepContext& step) {
    for (std::size_t i = 0; i < step.contacts.size(); ++i) step.rows[i].lo = 0;
  }
};

/// The mistake to avoid: each correction clamped, lambda >= 0. The sum may then never come back down, as if its lower
/// limit were wherever it has got to.
struct ClampingEachCorrection : Clamping {
  void sweep(StepContext& step) {
    for (Row& row : step.rows) row.lo = row.impulse;
  }
};

}  // namespace pushback
