/// All contacts at once, from where the last step ended.
#pragma once

#include <limits>

#include "pushback/chapters/17_direct_contacts/direct_contacts.h"
#include "pushback/chapters/17_direct_contacts/proximal_newton.h"
#include "pushback/chapters/19_accuracy_and_time/seat.h"

namespace pushback {

/// In the place of DirectContacts, after WarmStart, whose guess it goes on from: what rests is one linear system away from its
/// solution, or none. Only where Newton's method does not get there in `rounds` it is solved from nothing.
struct WarmDirectContacts : Effect {
  double tolerance = 1e-5;  ///< of relative_residual
  double too_far = 1e-3;    ///< of the same, and solved from nothing
  int rounds = 3;           ///< of Newton's method, see NewtonLimits

  void start(Step& step) {
    Rows& rows = step.rows;
    ContactProblem problem = problem_of(step.contacts, rows);
    if (problem.contacts() == 0) return;
    Vector r = Vector::Zero(problem.q.size());
    const std::vector<Eigen::Index> places = places_in_problem(step.contacts, rows);
    for (std::size_t i = 0; i < rows.size(); ++i) r[places[i]] = static_cast<double>(rows[i].impulse);
    problem.q -= problem.w * r;  // u = W r + q with what the guess has done already
    newton(problem, r, {tolerance, rounds, std::numeric_limits<double>::infinity()});
    if (!(relative_residual(problem, r) <= too_far)) r = solve_best(problem, {.tolerance = tolerance, .rounds = 1}).r;
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i].reach(static_cast<Real>(r[places[i]]));
  }
};

}  // namespace pushback
