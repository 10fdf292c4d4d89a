/// The matrix of all rows of a step. A_ij is the change of the speed of row i by a unit impulse on row j.
///
///   A = J M^-1 J^T,   A_ij = J_i (M^-1 J_j^T): 0 if rows i and j have no moving body in common
#pragma once

#include "pushback/chapters/01_velocity_constraint/row.h"
#include "pushback/engine/direct/contact_problem.h"

namespace pushback {

/// A, 1/kg. `softness`, 1/kg, is added to the diagonal. It has a number for each row, or is empty.
SparseMatrix matrix_of(const Rows& rows, const std::vector<Real>& softness = {});

/// J V + b of each row, m/s.
Vector speeds_of(const Rows& rows);

/// One row of projected Gauss-Seidel:   l_i <- clamp(l_i - (A l + b)_i / A_ii, lo, hi)
///
/// Called for all rows in turn, this is Sequential Impulses, which keeps J V in the bodies' velocities instead of summing it
/// from A.
void project_row(const SparseMatrix& a, const Vector& b, Eigen::Index i, double lo, double hi, Vector& impulses);

/// The problem of a world's contacts. q is J V for the present velocities, which World::begin_step has already updated.
/// r_n is along the normal of each contact, r_t along its tangents_of.
ContactProblem problem_of(World& world);

/// The problem of a solver's rows, q = J V + b. The first contacts.size() rows are the normals. Two tangents per contact may
/// follow. A contact without tangents has no friction.
ContactProblem problem_of(const Contacts& contacts, const Rows& rows);

/// The index of each of these rows in that problem, in which the normal of each contact is followed by its tangents.
std::vector<Eigen::Index> places_in_problem(const Contacts& contacts, const Rows& rows);

}  // namespace pushback
