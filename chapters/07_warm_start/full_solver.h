/// All seven chapters in one word.
#pragma once

#include "chapters/07_warm_start/warm_start.h"

namespace pushback {

using FullSolver = Solver<Clamping, Baumgarte, Slop, Restitution, Friction, WarmStart>;

}  // namespace pushback
