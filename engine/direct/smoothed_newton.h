/// All contacts at once: Newton's method on Coulomb's law without its kinks, which come back little by little.
///
/// In coordinates in which both cones are the same, x = (mu r_n, r_t) and z = (u_n / mu + |u_t|, u_t), the law of a contact is
/// x, z in the cone, x . z = 0. One vector y says both, x = Pi(y) and z = Pi(-y), with a kink where y enters the cone. Rounded,
///
///   x = (y + sqrt(y^2 + 4 t^2 e)) / 2,   z = (-y + sqrt(y^2 + 4 t^2 e)) / 2,   so x - z = y and x o z = t^2 e,
///
/// by the two eigenvalues y_n -+ |y_t| of y. For each t > 0 both are inside of the cone, as in an interior point method, and
///
///   W x + q - z + |z_t| n = 0
///
/// is smooth in y but where z_t = 0. Newton solves it for t, then for a smaller t from there. A redundant contact does no harm: where W leaves
/// x open, dz/dx > 0 does not.
///   M. Fukushima, Z.-Q. Luo, P. Tseng, "Smoothing functions for second-order-cone complementarity problems", 2002
#pragma once

#include "pushback/engine/direct/sweeping_methods.h"

namespace pushback {

struct SmoothedLimits {
  double tolerance = 1e-8;  ///< of relative_residual
  int systems = 100;        ///< linear systems at most
  double work = 1.5e10;     ///< multiplications, after which no further system is begun
};

struct SmoothedSolution : Solution {
  double entries = 0;  ///< numbers in the matrix of a system
  double fill = 0;     ///< numbers in its factors
};

/// From nothing. The best point met: `residual` says whether it is good enough. Where a smaller t cannot be reached, Newton's method
/// begins again at the last point of the path, with a smaller fall of t; it gives up once t would fall by less than 1 %. No solution
/// may be found where there is one: friction bends the path of y.
/// `factor`: B with W = B B^T (newton_system.h), or empty.
SmoothedSolution solve_smoothed(const ContactProblem& problem, const SmoothedLimits& limits = {},
                                const SparseMatrix& factor = {});

}  // namespace pushback
