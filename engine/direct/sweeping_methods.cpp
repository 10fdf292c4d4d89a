#include "pushback/engine/direct/sweeping_methods.h"

#include "pushback/common/basics/named.h"
#include "pushback/engine/direct/conjugate_sweeper.h"

namespace pushback {

namespace {

struct Method {
  const char* name;
  Sweep (*sweep)(const ContactProblem&);
};

template <class TangentStep>
Sweep sweep_by(const ContactProblem& problem) {
  return [sweeper = Sweeper<TangentStep>(problem)](Vector& r) { sweeper.sweep(r); };
}

Sweep conjugate(const ContactProblem& problem) {
  return [sweeper = ConjugateSweeper<ConeStep>(problem, Vector::Zero(problem.q.size()))](Vector& r) mutable {
    sweeper.sweep(r);
  };
}

constexpr Method methods[] = {{"pgs", sweep_by<PyramidStep>},
                              {"scaled-back", sweep_by<ScaledBackStep>},
                              {"cone", sweep_by<ConeStep>},
                              {"nscg", conjugate}};

}  // namespace

std::vector<std::string> sweeping_method_names() {
  return names_of(methods);
}

Sweep sweep_of(const ContactProblem& problem, const std::string& method) {
  return named("sweeping method", methods, method).sweep(problem);
}

Solution solve_by_sweeps(const ContactProblem& problem, const std::string& method, int sweeps, double tolerance) {
  const Sweep sweep = sweep_of(problem, method);
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
