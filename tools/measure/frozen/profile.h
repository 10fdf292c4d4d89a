/// Performance profiles: who is how far behind the best, on how many problems.
///
///   f_m(tau) = the part of all problems that method m solves within tau times the cost of whoever is cheapest there
///
/// f_m(1): where m is the cheapest. f_m(infinity): what it solves at all. E. Dolan, J. More, "Benchmarking optimization
/// software with performance profiles", 2002. A problem that nobody solves counts against all.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

namespace pushback::frozen {

inline constexpr double not_reached = std::numeric_limits<double>::infinity();

/// costs[p][m]: what method m takes for problem p, in any unit, above 0; not_reached where it does not solve it.
using Costs = std::vector<std::vector<double>>;

/// f of one method, for tau 1 or more. 0 where there are no problems.
inline double part_within(const Costs& costs, std::size_t method, double tau) {
  std::size_t within = 0;
  for (const std::vector<double>& of : costs) {
    const double cheapest = *std::min_element(of.begin(), of.end());
    if (of[method] < not_reached && of[method] <= tau * cheapest) ++within;
  }
  return costs.empty() ? 0 : static_cast<double>(within) / static_cast<double>(costs.size());
}

}  // namespace pushback::frozen
