/// Solves all contacts at once by Newton's method for Coulomb's law, with a proximal term that keeps the linear systems solvable.
///
/// The law of a contact is an equation with kinks (Alart, Curnier, 1991) with the step sizes of a sweep, a = 1 / W_nn, b = 1 / k:
///
///   f_n = r_n - max(0, r_n - a u_n),    f_t = r_t - P_disc(r_t - b u_t)        radius of the disc: mu max(0, r_n - a u_n)
///
/// A sweep changes nothing if and only if f = 0. Newton's method solves f' dr = -f for all contacts together. If W is singular,
/// so is f'. Therefore the speed gets a proximal term, u = W r + q + p (r - r_before). The solution is the next r_before, and p
/// decreases from round to round.
///   Acary, Bremond, Huber, "On solving contact problems with Coulomb friction", 2018, compare such methods.
#pragma once

#include "pushback/engine/direct/contact_problem.h"

namespace pushback {

struct ProximalLimits {
  double tolerance;  ///< of relative_residual
  int rounds;        ///< values of r_before, at most; each takes up to 40 linear systems
  double work;       ///< multiplications, after which no further linear system begins
};

struct ProximalStats {
  int systems = 0;  ///< linear systems solved
  /// Multiplications of the factorizations, as if all columns of L and all rows of U were equally long, and of W r for each
  /// step length.
  double work = 0;
};

/// r becomes the point with the smallest residual that was found, if that is smaller than the residual of r.
ProximalStats solve_proximal(const ContactProblem& problem, Vector& r, const ProximalLimits& limits);

}  // namespace pushback
