/// The solver of chapters 01 to 07 as one type.
#pragma once

#include "pushback/chapters/07_warm_start/warm_start.h"

namespace pushback {

using FullSolver = Solver<Clamping, Baumgarte, Slop, Restitution, Friction, WarmStart>;

}  // namespace pushback
