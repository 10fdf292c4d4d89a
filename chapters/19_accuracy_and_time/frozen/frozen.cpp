#include "pushback/chapters/19_accuracy_and_time/frozen/frozen.h"

#include <algorithm>

#include "pushback/chapters/19_accuracy_and_time/frozen/methods.h"
#include "pushback/chapters/19_accuracy_and_time/frozen/traced.h"

namespace pushback::frozen {

namespace {

Traced traced(const FrozenProblem& frozen, const FrozenOptions& options) {
  TraceLimits limits;
  limits.asked.assign(tolerances.begin(), tolerances.end());
  if (options.quick) {
    limits.seconds = 0.03;
    limits.work = 1e8;
    limits.ladder = limits.asked;
  }
  Traced all{&frozen, {}};
  for (const std::string& method : frozen_methods()) all.traces.emplace_back(frozen.problem, method, limits);
  double longest = 0;  // s, of one method
  for (const Trace& trace : all.traces)
    if (!trace.points().empty()) longest = std::max(longest, trace.points().back().time());
  const int rounds = options.quick || longest > limits.seconds / 4 ? 3 : 7;
  for (int round = 1; round < rounds; ++round)
    for (Trace& trace : all.traces) trace.again();
  return all;
}

}  // namespace

FrozenStudy study_frozen(const FrozenOptions& options) {
  std::vector<FrozenProblem> problems;
  if (options.folder)
    problems = foreign_problems(*options.folder);  // first: a bad folder is said before anything takes time
  const std::vector<FrozenProblem> own = own_problems();
  problems.insert(problems.begin(), own.begin(), own.end());
  std::vector<Traced> all;
  for (const FrozenProblem& problem : problems) all.push_back(traced(problem, options));
  FrozenStudy study{remarks_of(all), reached_of(all), tables_of(all), csv_of(all)};
  if (!options.folder) study.remarks.push_back("no folder of foreign problems was given: only our own are here");
  return study;
}

}  // namespace pushback::frozen
