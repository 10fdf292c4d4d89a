#include "pushback/chapters/17_direct_contacts/methods.h"

#include <algorithm>
#include <stdexcept>

#include "pushback/chapters/17_direct_contacts/pivoting.h"
#include "pushback/common/basics/input.h"
#include "pushback/engine/direct/smoothed_newton.h"

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

Solution solve_frictionless(const ContactProblem& problem) {
  if ((problem.mu.array() != 0).any())
    throw InvalidInput("pivoting solves contacts without friction alone: mu is not 0");
  std::vector<Eigen::Triplet<double>> normal_entries;
  for (Eigen::Index i = 0; i < problem.contacts(); ++i)
    for (SparseMatrix::InnerIterator entry(problem.w, 3 * i); entry; ++entry)
      if (entry.col() % 3 == 0) normal_entries.emplace_back(i, entry.col() / 3, entry.value());
  SparseMatrix a(problem.contacts(), problem.contacts());
  a.setFromTriplets(normal_entries.begin(), normal_entries.end());
  const auto every_third = Eigen::seqN(0, problem.contacts(), 3);
  const std::optional<Pivoted> found = solve_by_pivoting(a, problem.q(every_third));
  if (!found) throw std::runtime_error("pivoting has found no solution");
  Solution solution{.r = Vector::Zero(3 * problem.contacts())};
  solution.r(every_third) = found->impulses;
  solution.residual = relative_residual(problem, solution.r);
  solution.pivots = found->pivots;
  return solution;
}

}  // namespace pushback
