/// A step starts from its solution: sweeps that follow have nothing left to do.
#pragma once

#include "chapters/08_friction_cone/friction_cone.h"
#include "chapters/13_global_solve/best.h"
#include "chapters/13_global_solve/matrix.h"

namespace pushback {

/// Beside Clamping and FrictionCone, last.   l = what solves u = W l + q with the law of each contact, all at once
///
/// What no method brings below `tolerance` is left to the sweeps, from the best point met.
struct GlobalSolve : Effect {
  double tolerance = 1e-10;  ///< of relative_residual

  void build(const Contacts& contacts, Rows&, Real) { contacts_ = &contacts; }
  void start(Rows& rows) {
    const ContactProblem problem = problem_of(*contacts_, rows);
    if (problem.contacts() == 0) return;
    solution_ = solve_best(problem, {.tolerance = tolerance, .rounds = 1});
    const std::vector<Eigen::Index> places = places_in_problem(*contacts_, rows);
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i].reach(static_cast<Real>(solution_.r[places[i]]));
  }
  const Solution& solution() const { return solution_; }

 private:
  const Contacts* contacts_ = nullptr;  // of the step that is being solved
  Solution solution_;
};

}  // namespace pushback
