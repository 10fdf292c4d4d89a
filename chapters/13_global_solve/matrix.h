/// All rows of a step written out: how an impulse on each changes the speed of every other.
///
///   A = J M^-1 J^T,   A_ij = J_i (M^-1 J_j^T): 0 where row i and row j have no moving body in common
#pragma once

#include "chapters/01_velocity_constraint/row.h"
#include "chapters/13_global_solve/contact_problem.h"

namespace pushback {

/// 1/kg, a row and a column for each of `rows`. Softness, where a row has it, is added on the diagonal.
SparseRows matrix_of(const Rows& rows);

/// J V + b of each row, m/s: what A lambda has to make up for.
Vector speeds_of(const Rows& rows);

/// One sweep of projected Gauss-Seidel:   l_i <- clamp(l_i - (A l + b)_i / A_ii, lo_i, hi_i), i in their order.
///
/// This is sequential impulses. There JV is kept in the bodies' velocities, here it is worked out from A: the same number.
void sweep(const SparseRows& a, const Vector& b, const Vector& lo, const Vector& hi, Vector& impulses);

/// A step's contacts as a problem for any solver: each with its normal and its two tangents, whatever they touch. u is in the
/// frame of the contact, its biases those of `rows`, q = JV + b as the bodies move now. Contacts without tangents among the
/// rows, and all where `rows` is empty, get them here, and friction 0 or their own.
ContactProblem problem_of(const Contacts& contacts);

}  // namespace pushback
