/// A contact pushes and never pulls, so the impulse that it accumulates over the sweeps is not negative.
#pragma once

#include "pushback/chapters/01_velocity_constraint/solver.h"

namespace pushback {

/// sum(lambda) in [0, inf)
struct Clamping : Effect {
  void build(StepContext& step) {
    for (std::size_t i = 0; i < step.contacts.size(); ++i) step.rows[i].lo = 0;
  }
};

/// The mistake to avoid is to clamp each correction, lambda >= 0, not the sum. The sum can then only grow, although a later
/// sweep may find that it is too large.
struct ClampingEachCorrection : Clamping {
  void sweep(StepContext& step) {
    for (Row& row : step.rows) row.lo = row.impulse;
  }
};

}  // namespace pushback
