#include "pushback/chapters/17_direct_contacts/methods.h"

#include <algorithm>

#include "pushback/chapters/17_direct_contacts/smoothed_newton.h"

namespace pushback {

std::vector<std::string> method_names() {
  std::vector<std::string> names = sweeping_method_names();
  names.emplace_back("smoothed");
  names.emplace_back("best");
  return names;
}

bool counts_sweeps(const std::string& method) {
  return method != "smoothed" && method != "best";
}

Solution solve(const ContactProblem& problem, const std::string& method, int sweeps, double tolerance) {
  if (method == "best") return solve_best(problem, {.tolerance = tolerance});
  if (method == "smoothed") return solve_smoothed(problem, {.tolerance = tolerance});
  return solve_by_sweeps(problem, method, sweeps, tolerance);
}

}  // namespace pushback
