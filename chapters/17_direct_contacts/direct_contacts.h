/// A direct solve of all contacts as the initial guess of a step, which leaves nothing for the sweeps to correct.
#pragma once

#include "pushback/chapters/08_friction_cone/friction_cone.h"
#include "pushback/engine/direct/row_matrix.h"
#include "pushback/engine/direct/solve_best.h"

namespace pushback {

/// Listed last, after Clamping and FrictionCone. Solves u = W l + q with the law of each contact, for all contacts at once.
///
/// If no method reaches `tolerance`, the sweeps start from the best solution found.
struct DirectContacts : Effect {
  double tolerance = 1e-10;  ///< of relative_residual

  void start(StepContext& step) {
    const ContactProblem problem = problem_of(step.contacts, step.rows);
    if (problem.contacts() == 0) return;
    solution_ = solve_best(problem, {.tolerance = tolerance, .rounds = 1});
    const std::vector<Eigen::Index> places = places_in_problem(step.contacts, step.rows);
    for (std::size_t i = 0; i < step.rows.size(); ++i) step.rows[i].reach(static_cast<Real>(solution_.r[places[i]]));
  }
  const Solution& solution() const { return solution_; }

 private:
  Solution solution_;
};

}  // namespace pushback
