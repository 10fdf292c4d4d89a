/// Solves all contacts at once by Newton's method for a smoothed form of Coulomb's law, which approaches the exact law from system
/// to system.
///
/// In coordinates in which both cones are the same, x = (mu r_n, r_t) and z = (u_n / mu + |u_t|, u_t), the law of a contact is
/// x, z in the cone, x . z = 0. One vector y determines both, x = Pi(y) and z = Pi(-y), with a kink where y enters the cone.
/// Smoothed,
///
///   x = (y + sqrt(y^2 + 4 t^2 e)) / 2,   z = (-y + sqrt(y^2 + 4 t^2 e)) / 2,   so x - z = y and x o z = t^2 e,
///
/// where the square root acts on the two eigenvalues y_n -+ |y_t| of y. For each t > 0 both are inside the cone, as in an
/// interior point method, and
///
///   W x + q - z + |z_t| n = 0
///
/// is smooth in y except at z_t = 0. Newton's method solves it for one t, then from there for a smaller t. Redundant contacts
/// are harmless, because the term dz/dx > 0 determines x if W does not.
///   M. Fukushima, Z.-Q. Luo, P. Tseng, "Smoothing functions for second-order-cone complementarity problems", 2002
#pragma once

#include "pushback/engine/direct/sweeping_methods.h"

namespace pushback {

struct SmoothedLimits {
  double tolerance = 1e-8;  ///< of relative_residual
  int systems = 100;        ///< linear systems at most
  double work = 1.5e10;     ///< multiplications, after which no further system begins
};

struct SmoothedSolution : Solution {
  double entries = 0;  ///< numbers in the matrix of a system
  double fill = 0;     ///< numbers in its factors
};

/// Starts without a guess, and returns the point with the smallest residual that was found. If a smaller t cannot be reached,
/// Newton's method starts again from the last solved t, with a smaller decrease of t. It gives up once t would decrease by less
/// than 1 %. It may miss a solution that exists, because friction can bend the path of y(t) back.
/// `factor`: B with W = B B^T (newton_system.h), or empty.
SmoothedSolution solve_smoothed(const ContactProblem& problem, const SmoothedLimits& limits = {},
                                const SparseMatrix& factor = {});

}  // namespace pushback
