#include "pushback/engine/direct/warm_direct_contacts.h"

#include <fmt/format.h>

#include "pushback/common/basics/input.h"
#include "pushback/engine/direct/newton_system.h"
#include "pushback/engine/direct/proximal_newton.h"
#include "pushback/engine/direct/row_matrix.h"
#include "pushback/engine/direct/small_contact_problem.h"
#include "pushback/engine/direct/smoothed_newton.h"
#include "pushback/engine/direct/solve_best.h"

namespace pushback {

/// Contacts. With more, one system with 3 rows per contact takes longer than all systems of solve_smoothed with 6 rows per
/// body.
constexpr Eigen::Index most_from_guess = 100;

std::string WarmDirectContacts::too_large_message(std::size_t contacts) {
  return fmt::format("{} contacts are too large a problem for the multiplications that are left", contacts);
}

void WarmDirectContacts::start(StepContext& step) {
  if (!try_start(step)) throw InvalidInput(too_large_message(step.contacts.size()));
}

bool WarmDirectContacts::try_start(StepContext& step) {
  if (step.contacts.empty()) return true;
  evaluate_guess(step);
  if (relative_residual(r_, u_, q_, mu_) <= tolerance) return true;  // a resting scene: W is not needed
  if (!solve_small_problem(step.rows) && !solve_large_problem(step)) return false;
  for (std::size_t i = 0; i < places_.size(); ++i) step.rows[i].reach(static_cast<Real>(r_[places_[i]]));
  return true;
}

/// Removes the guess from the bodies and applies it again. Their velocities then give q and u without W.
void WarmDirectContacts::evaluate_guess(StepContext& step) {
  Rows& rows = step.rows;
  places_ = places_in_problem(step.contacts, rows);
  for (Vector* all : {&r_, &u_, &q_}) all->setZero(3 * static_cast<Eigen::Index>(step.contacts.size()));
  mu_.setZero(static_cast<Eigen::Index>(step.contacts.size()));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    r_[places_[i]] = static_cast<double>(rows[i].impulse);
    rows[i].reach(0);
    if (i >= step.contacts.size())
      mu_[static_cast<Eigen::Index>(rows[i].owner)] = static_cast<double>(step.contacts[rows[i].owner].friction);
  }
  for (std::size_t i = 0; i < rows.size(); ++i) q_[places_[i]] = static_cast<double>(step.speed_error(i));
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i].reach(static_cast<Real>(r_[places_[i]]));
  for (std::size_t i = 0; i < rows.size(); ++i) u_[places_[i]] = static_cast<double>(step.speed_error(i));
}

bool WarmDirectContacts::solve_small_problem(const Rows& rows) {
  if (mu_.size() > SmallContactProblem::most_contacts || static_cast<Eigen::Index>(rows.size()) < r_.size())
    return false;
  SmallContactProblem::Impulses r = r_;
  if (!solve_small({small_matrix_of(rows, places_), q_, mu_}, r, tolerance)) return false;
  r_ = r;
  return true;
}

bool WarmDirectContacts::solve_large_problem(StepContext& step) {
  if (!(work > 0)) return false;
  ContactProblem problem = problem_of(step.contacts, step.rows);
  problem.q -= problem.w * r_;  // u = W r + q with what the guess has done already
  if (mu_.size() <= most_from_guess) {
    work -= solve_proximal(problem, r_, {tolerance, rounds, work}).work;
    if (relative_residual(problem, r_) <= fallback_tolerance) return true;
  }
  const SmoothedSolution smoothed =
      solve_smoothed(problem, {.tolerance = tolerance, .work = work}, factor_of(step.world, step.contacts));
  work -= smoothed.work;
  if (smoothed.residual < relative_residual(problem, r_)) r_ = smoothed.r;
  if (relative_residual(problem, r_) <= fallback_tolerance) return true;
  const Solution from_nothing = solve_best(problem, {.tolerance = tolerance, .work = work, .rounds = 1});
  work -= from_nothing.work;
  if (from_nothing.residual < relative_residual(problem, r_)) r_ = from_nothing.r;
  return true;
}

}  // namespace pushback
