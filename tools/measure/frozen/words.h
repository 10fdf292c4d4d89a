/// What is said of frozen problems: tables and sentences, markdown.
#pragma once

#include <string>
#include <vector>

#include "pushback/tools/measure/frozen/points.h"
#include "pushback/tools/measure/frozen/problems.h"

namespace pushback::frozen {

/// One for each tolerance, with its heading.
std::vector<std::string> tables_of(const FrozenPoints& all);
/// A row a method: on how many problems it comes that far, on how many it is the fastest, and its time as a multiple of the
/// fastest one's, the median of those it reaches. For each tolerance.
std::string reached_of(const FrozenPoints& all);
/// What the numbers say, a sentence each. Throws InvalidInput where a problem is none of `problems`.
std::vector<std::string> remarks_of(const FrozenPoints& all, const std::vector<FrozenProblem>& problems);

}  // namespace pushback::frozen
