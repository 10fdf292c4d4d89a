#include "pushback/tools/measure/frozen/frozen.h"

#include <fmt/format.h>

#include <algorithm>

#include "pushback/tools/measure/frozen/methods.h"
#include "pushback/tools/measure/frozen/points.h"

namespace pushback::frozen {

namespace {

TraceLimits limits_of(bool quick) {
  TraceLimits limits;
  limits.asked.assign(tolerances.begin(), tolerances.end());
  if (quick) {
    limits.seconds = 0.03;
    limits.work = 1e8;
    limits.ladder = limits.asked;
  }
  return limits;
}

/// All methods, once.
Traced traced(const FrozenProblem& frozen, const TraceLimits& limits) {
  Traced all{&frozen, {}};
  for (const std::string& method : frozen_methods())
    all.traces.emplace_back(frozen.problem, method, limits, frozen.factor);
  return all;
}

Traced traced(const FrozenProblem& frozen, bool quick) {
  const TraceLimits limits = limits_of(quick);
  Traced all = traced(frozen, limits);
  double longest = 0;  // s, of one method
  for (const Trace& trace : all.traces)
    if (!trace.points().empty()) longest = std::max(longest, trace.points().back().time());
  const int rounds = quick || longest > limits.seconds / 4 ? 3 : 7;
  for (int round = 1; round < rounds; ++round)
    for (Trace& trace : all.traces) trace.again();
  return all;
}

}  // namespace

std::string csv_of(const std::vector<Traced>& all) {
  std::string text = fmt::format("{}\n", csv_heading);
  for (const Traced& of : all)
    for (std::size_t m = 0; m < of.traces.size(); ++m)
      for (const TracePoint& point : of.traces[m].points())
        text += fmt::format("{},{},{},{},{},{},{:.6e},{:.3e},{:.3e},{:.3e}\n", of.frozen->name,
                            of.frozen->problem.contacts(), frozen_methods()[m], point.sweeps,
                            of.traces[m].counts_rows() ? fmt::format("{:.0f}", of.traces[m].row_solves(point)) : "-",
                            point.systems, point.residual, point.time(), point.time(0.25), point.time(0.75));
  return text;
}

std::string study_frozen(const std::vector<FrozenProblem>& problems, bool quick) {
  std::vector<Traced> all;
  for (const FrozenProblem& problem : problems) all.push_back(traced(problem, quick));
  return csv_of(all);
}

std::string study_large(const std::vector<FrozenProblem>& problems, bool quick) {
  TraceLimits limits = limits_of(quick);
  if (!quick) {
    limits.seconds = 10;
    limits.work = 2e10;
    limits.ladder = limits.asked;
  }
  std::vector<Traced> all;
  for (const FrozenProblem& problem : problems) all.push_back(traced(problem, limits));
  return csv_of(all);
}

}  // namespace pushback::frozen
