/// All contacts at once: Newton's method on Coulomb's law, made safe by pulling at where it came from.
///
/// The law of a contact as an equation that has kinks (Alart, Curnier, 1991), with steps a = 1 / W_nn, b = 1 / k as in a sweep:
///
///   f_n = r_n - max(0, r_n - a u_n),    f_t = r_t - P_disc(r_t - b u_t), the disc of radius mu max(0, r_n - a u_n)
///
/// f = 0 is what a sweep is after. Newton solves f' dr = -f for all contacts together. Where W is singular, f' is: so solve a
/// problem that is not, u = W r + q + p (r - r_before), then the next one from there, with p smaller and smaller.
///   Acary, Bremond, Huber, "On solving contact problems with Coulomb friction", 2018, compare such methods.
#pragma once

#include "pushback/engine/direct/contact_problem.h"

namespace pushback {

struct ProximalLimits {
  double tolerance;  ///< of relative_residual: this is good enough
  int rounds;        ///< proximal points at most; one takes up to 40 linear systems
  double work;       ///< after which no further linear system is begun
};

struct ProximalStats {
  int systems = 0;  ///< linear systems solved
  /// Those of the factorizations, as if all columns of L and all rows of U were equally long, and of W r when a step is tried.
  double work = 0;
};

/// r becomes the best point that was met, if one was better.
ProximalStats solve_proximal(const ContactProblem& problem, Vector& r, const ProximalLimits& limits);

}  // namespace pushback
