#include "chapters/13_global_solve/methods.h"

#include "chapters/13_global_solve/conjugate.h"
#include "common/input.h"

namespace pushback {

namespace {

template <class Sweep>
Solution swept(const ContactProblem& problem, Sweep sweep, int sweeps, double tolerance) {
  Solution solution{.r = Vector::Zero(problem.q.size())};
  solution.residual = relative_residual(problem, solution.r);
  while (solution.sweeps < sweeps && solution.residual > tolerance) {
    sweep(solution.r);
    ++solution.sweeps;
    if (solution.sweeps % 10 == 0 || solution.sweeps == sweeps)
      solution.residual = relative_residual(problem, solution.r);
  }
  return solution;
}

template <class TangentStep>
Solution swept(const ContactProblem& problem, int sweeps, double tolerance) {
  const Sweeper<TangentStep> sweeper(problem);
  return swept(problem, [&](Vector& r) { sweeper.sweep(r); }, sweeps, tolerance);
}

}  // namespace

std::vector<std::string> method_names() {
  return {"pgs", "scaled-back", "cone", "nscg", "best"};
}

Solution solve(const ContactProblem& problem, const std::string& method, int sweeps, double tolerance) {
  if (method == "pgs") return swept<Pyramid>(problem, sweeps, tolerance);
  if (method == "scaled-back") return swept<ScaledBackStep>(problem, sweeps, tolerance);
  if (method == "cone") return swept<Cone>(problem, sweeps, tolerance);
  if (method == "nscg") {
    ConjugateSweeper<Cone> sweeper(problem, Vector::Zero(problem.q.size()));
    return swept(problem, [&](Vector& r) { sweeper.sweep(r); }, sweeps, tolerance);
  }
  if (method == "best") return solve_best(problem, {.tolerance = tolerance});
  throw InvalidInput(fmt::format("method is '{}': one of {} is needed", method, fmt::join(method_names(), ", ")));
}

}  // namespace pushback
