/// What is said and drawn of frozen problems, of frozen.csv alone: again at any time, without solving anything.
#pragma once

#include "pushback/common/experiment/plot.h"
#include "pushback/tools/measure/frozen/points.h"
#include "pushback/tools/measure/frozen/problems.h"

namespace pushback::frozen {

/// Markdown. One for each tolerance, with its heading.
std::vector<std::string> tables_of(const FrozenPoints& all);
/// Markdown. A row a method: on how many problems it comes that far, on how many it is the fastest, and its time as a multiple of the
/// fastest one's, the median of those it reaches. For each tolerance.
std::string reached_of(const FrozenPoints& all);
/// What else the numbers say, a sentence each. Throws InvalidInput where a problem is none of `problems`.
std::vector<std::string> remarks_of(const FrozenPoints& all, const std::vector<FrozenProblem>& problems);

/// Residual against time and against row solves, of the six problems that tell most.
std::vector<Panel> trace_panels(const FrozenPoints& all);
/// Performance profiles: three of time, one of row solves.
std::vector<Panel> profile_panels(const FrozenPoints& all);

}  // namespace pushback::frozen
