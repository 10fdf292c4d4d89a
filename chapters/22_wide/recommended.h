/// The solver to take where no chapter is the subject.
#pragma once

#include "pushback/chapters/22_wide/wide.h"

namespace pushback {

/// Soft contacts, a friction cone, simultaneous impacts, warm start; joints, limits and motors solved directly; 32 substeps, for which
/// contacts are detected once.
///
///   Recommended solver;
///   world.step(solver, 1.0 / 60);
using Recommended = Wide<Real>;

}  // namespace pushback
