/// Whatever it takes, up to a count of multiplications: sweeps until it has settled which contacts stick, slide or part,
/// then Newton's method.
#pragma once

#include "pushback/engine/direct/sweeping_methods.h"

namespace pushback {

struct SolveLimits {
  double tolerance = 1e-13;  ///< of relative_residual: below this nothing more is done
  double work = 1.5e10;  ///< multiplications after which nothing new is begun: about a minute, and no clock is asked
  int rounds = 12;       ///< of sweeps and Newton's method, at most
};

/// The work is counted, so that the same problem ends at the same place, in the same bits, on a fast machine and a slow one:
/// a sweep has one multiplication for each number in W; for a linear system see solve_proximal.
///
/// The best point met. Where Newton fails, more sweeps go before it; after that, sweeps in other orders, since where a problem
/// has many solutions, each order goes for another one.
Solution solve_best(const ContactProblem& problem, const SolveLimits& limits = {});

}  // namespace pushback
