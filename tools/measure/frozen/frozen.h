/// What accuracy costs on one problem: every method on every frozen problem, how far it comes in what time.
#pragma once

#include <string>
#include <vector>

#include "pushback/tools/measure/frozen/problems.h"
#include "pushback/tools/measure/frozen/trace.h"

namespace pushback::frozen {

/// All methods on one problem.
struct Traced {
  const FrozenProblem* frozen;
  std::vector<Trace> traces;  ///< in the order of frozen_methods()
};
/// What points.h reads.
std::string csv_of(const std::vector<Traced>& all);

/// frozen.csv of these problems. Takes minutes, or seconds if quick: a thirtieth of a second for each, fewer tolerances. Rounds
/// go over all methods, one after the other, and then over all again. Sweeps, systems and residuals are the same whenever they
/// are there; times, and so who is fastest, are those of the day.
std::string study_frozen(const std::vector<FrozenProblem>& problems, bool quick);
/// The same of large problems: 10 s for each method, once.
std::string study_large(const std::vector<FrozenProblem>& problems, bool quick);

}  // namespace pushback::frozen
