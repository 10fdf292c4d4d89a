/// An exact solution of contacts without friction. Pivoting finds which of them press and which separate.
#pragma once

#include <optional>

#include "pushback/engine/direct/contact_problem.h"

namespace pushback {

struct Pivoted {
  Vector impulses;  ///< N s
  int pivots = 0;
};

/// l >= 0, A l + b >= 0, l . (A l + b) = 0, for A symmetric and positive semi-definite, of any rank.
///
/// Lemke's method relaxes all rows by z, A l + b + z >= 0, so that l = 0 is a solution, and then pivots until z is 0. The contacts
/// of a face are redundant, so ties are common, and ties can make pivoting cycle. So each b is first relaxed by a different amount
/// of about 1e-7 of the largest. This determines which rows press, and those rows are then solved with the original b. Returns
/// nothing if no l exists, or if 100 pivots per row are not enough.
///   Cottle, Pang, Stone, "The Linear Complementarity Problem", 1992, 4.4 and 4.9
std::optional<Pivoted> solve_by_pivoting(const SparseMatrix& a, const Vector& b);

/// The largest |min(l_i, (A l + b)_i)|, in N s or m/s, whichever is smaller. It is 0 exactly if l is a solution.
double complementarity_error(const SparseMatrix& a, const Vector& b, const Vector& impulses);

}  // namespace pushback
