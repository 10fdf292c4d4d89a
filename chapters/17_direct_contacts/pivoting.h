/// Contacts without friction, solved exactly: who presses and who parts, found by pivoting.
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
/// Lemke's method: loosen all rows by z, A l + b + z >= 0, so far that l = 0 will do; then bring in one number after the other
/// until z is 0. The contacts of a face say the same thing more than once, so that ties are the rule, and ties can go round in
/// circles: each b is first loosened by another 1e-7 or so of the largest. Who presses is then known, and those rows are solved
/// with b as it is. Nothing is returned where no l exists, or where 100 pivots a row did not do.
///   Cottle, Pang, Stone, "The Linear Complementarity Problem", 1992, 4.4 and 4.9
std::optional<Pivoted> solve_by_pivoting(const SparseRows& a, const Vector& b);

/// The largest |min(l_i, (A l + b)_i)|: 0 exactly where l solves. In N s or m/s, whichever is smaller.
double complementarity_error(const SparseRows& a, const Vector& b, const Vector& impulses);

}  // namespace pushback
