/// What was traced, and what is made of it: words (words.cpp), and what pictures.h draws.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "pushback/chapters/19_accuracy_and_time/frozen/problems.h"
#include "pushback/chapters/19_accuracy_and_time/frozen/profile.h"
#include "pushback/chapters/19_accuracy_and_time/frozen/trace.h"

namespace pushback::frozen {

inline constexpr std::array tolerances{1e-3, 1e-6, 1e-10};  ///< of relative_residual: what is asked for

/// All methods on one problem.
struct Traced {
  const FrozenProblem* frozen;
  std::vector<Trace> traces;  ///< in the order of frozen_methods()
};

/// Median s to the tolerance, problem by problem.
Costs times_to(double tolerance, const std::vector<Traced>& all);
/// Whether any of its points took linear systems, so that row solves are not all of its work.
bool solves_systems(std::size_t method, const std::vector<Traced>& all);

std::vector<std::string> tables_of(const std::vector<Traced>& all);
/// A row a method: on how many problems it comes that far, on how many it is the fastest, and its time as a multiple of the
/// fastest one's, the median of those it reaches. For each tolerance.
std::string reached_of(const std::vector<Traced>& all);
std::vector<std::string> remarks_of(const std::vector<Traced>& all);
std::string csv_of(const std::vector<Traced>& all);

}  // namespace pushback::frozen
