#include "pushback/chapters/17_direct_contacts/methods.h"

namespace pushback {

std::vector<std::string> method_names() {
  std::vector<std::string> names = sweeping_method_names();
  names.emplace_back("best");
  return names;
}

Solution solve(const ContactProblem& problem, const std::string& method, int sweeps, double tolerance) {
  if (method == "best") return solve_best(problem, {.tolerance = tolerance});
  return solve_by_sweeps(problem, method, sweeps, tolerance);
}

}  // namespace pushback
