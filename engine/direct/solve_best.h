/// Solves a contact problem by sweeps, until it is settled which contacts stick, slide or part, and then by Newton's method.
#pragma once

#include "pushback/engine/direct/sweeping_methods.h"

namespace pushback {

struct SolveLimits {
  double tolerance = 1e-13;  ///< of relative_residual
  double work = 1.5e10;      ///< multiplications, after which no sweep and no linear system begins: about a minute
  int rounds = 12;           ///< of sweeps and Newton's method, at most
};

/// Returns the impulses with the smallest residual that were found. If Newton's method fails, the next attempt begins with more
/// sweeps. Later rounds sweep the contacts in other orders, because sweeps in another order find another solution if there are
/// several.
///
/// Work is counted in multiplications, not in seconds, so that a fast and a slow machine stop at the same point, with the same
/// bits. A sweep counts one multiplication for each number in W. For a linear system see solve_proximal.
Solution solve_best(const ContactProblem& problem, const SolveLimits& limits = {});

}  // namespace pushback
