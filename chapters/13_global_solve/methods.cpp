#include "pushback/chapters/13_global_solve/methods.h"

#include "pushback/chapters/13_global_solve/conjugate.h"
#include "pushback/common/basics/input.h"

namespace pushback {

namespace {

template <class TangentStep>
Sweep sweep_by(const ContactProblem& problem) {
  return [sweeper = Sweeper<TangentStep>(problem)](Vector& r) { sweeper.sweep(r); };
}

}  // namespace

std::vector<std::string> method_names() {
  return {"pgs", "scaled-back", "cone", "nscg", "best"};
}

Sweep sweep_of(const ContactProblem& problem, const std::string& method) {
  if (method == "pgs") return sweep_by<Pyramid>(problem);
  if (method == "scaled-back") return sweep_by<ScaledBackStep>(problem);
  if (method == "cone") return sweep_by<Cone>(problem);
  if (method == "nscg")
    return [sweeper = ConjugateSweeper<Cone>(problem, Vector::Zero(problem.q.size()))](Vector& r) mutable {
      sweeper.sweep(r);
    };
  if (method == "best") return {};
  throw InvalidInput(fmt::format("method is '{}': one of {} is needed", method, fmt::join(method_names(), ", ")));
}

Solution solve(const ContactProblem& problem, const std::string& method, int sweeps, double tolerance) {
  const Sweep sweep = sweep_of(problem, method);
  if (!sweep) return solve_best(problem, {.tolerance = tolerance});
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

}  // namespace pushback
