/// Solves all contacts at once, starting from the impulses of the previous step.
#pragma once

#include "pushback/chapters/08_friction_cone/friction_cone.h"

namespace pushback {

/// Replaces DirectContacts, and starts from the guess of WarmStart, which has to precede it in the solver's list. A resting
/// scene needs one linear system, or none. If Newton's method does not converge in `rounds`, or if there are many contacts,
/// solve_smoothed starts without the guess. If its residual is above `fallback_tolerance`, solve_best follows, as in
/// DirectContacts.
struct WarmDirectContacts : Effect {
  double tolerance = 1e-5;           ///< of relative_residual
  double fallback_tolerance = 1e-3;  ///< of the same: if a method leaves more, the next one is tried
  int rounds = 3;                    ///< of Newton's method, see ProximalLimits
  /// The multiplications that are left for all steps together. At 0, steps that need a linear system fail.
  double work = std::numeric_limits<double>::infinity();

  /// Throws InvalidInput if `work` is spent.
  void start(StepContext& step);
  /// The same, but returns false instead of throwing.
  bool try_start(StepContext& step);
  /// The error message if `work` is spent.
  static std::string too_large_message(std::size_t contacts);

 private:
  void evaluate_guess(StepContext& step);
  bool solve_small_problem(const Rows& rows);
  bool solve_large_problem(StepContext& step);

  std::vector<Eigen::Index> places_;  // of each row in the problem
  Eigen::VectorXd r_, u_, q_, mu_;    // of the problem, where u is with r and q without
};

}  // namespace pushback
