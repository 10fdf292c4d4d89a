/// The diagrams of frozen problems, drawn from frozen.csv alone: again at any time, without solving anything.
#pragma once

#include <vector>

#include "pushback/common/experiment/plot.h"
#include "pushback/tools/measure/frozen/points.h"

namespace pushback::frozen {

/// Residual against time and against row solves, of the six problems that tell most.
std::vector<Panel> trace_panels(const FrozenPoints& all);
/// Performance profiles: three of time, one of row solves.
std::vector<Panel> profile_panels(const FrozenPoints& all);

}  // namespace pushback::frozen
