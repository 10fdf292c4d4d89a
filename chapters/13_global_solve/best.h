/// Whatever it takes, within a minute: sweeps until the contacts know who sticks and who slides, then Newton.
#pragma once

#include "chapters/13_global_solve/contact_problem.h"

namespace pushback {

struct Solution {
  Vector r;             ///< N s
  double residual = 0;  ///< relative_residual
  int sweeps = 0;       ///< over all contacts
  int systems = 0;      ///< linear systems solved
};

struct Effort {
  double tolerance = 1e-13;  ///< of relative_residual: below this nothing more is done
  double seconds = 55;  ///< after which nothing new is begun; as long as it is not reached, the result is the same bits
  int rounds = 12;      ///< of sweeps and Newton's method, at most
};

/// The best point met. Where Newton fails, more sweeps go before it; after that, sweeps in other orders, since where a problem
/// has many solutions, each order goes for another one.
Solution solve_best(const ContactProblem& problem, const Effort& effort = {});

}  // namespace pushback
