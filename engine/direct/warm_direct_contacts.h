/// All contacts at once, from where the last step ended.
#pragma once

#include "pushback/chapters/08_friction_cone/friction_cone.h"

namespace pushback {

/// In the place of DirectContacts, after WarmStart, whose guess it goes on from: what rests is one linear system away from its
/// solution, or none. Only where Newton's method does not get there in `rounds`, or where there are many contacts, it is solved
/// from nothing: smoothed, between bodies, and where that ends too far off, as DirectContacts does.
struct WarmDirectContacts : Effect {
  double tolerance = 1e-5;           ///< of relative_residual
  double fallback_tolerance = 1e-3;  ///< of the same, and solved from nothing
  int rounds = 3;                    ///< of Newton's method, see ProximalLimits
  /// Multiplications in all steps together. Once they are spent, the next system is refused.
  double work = std::numeric_limits<double>::infinity();

  /// Throws InvalidInput if `work` is spent.
  void start(StepContext& step);
  /// The same, but returns false.
  bool try_start(StepContext& step);
  static std::string too_large_message(std::size_t contacts);

 private:
  void evaluate_guess(StepContext& step);
  bool solve_small_problem(const Rows& rows);
  bool solve_large_problem(StepContext& step);

  std::vector<Eigen::Index> places_;  // of each row in the problem
  Eigen::VectorXd r_, u_, q_, mu_;    // of the problem, u with r, q without
};

}  // namespace pushback
