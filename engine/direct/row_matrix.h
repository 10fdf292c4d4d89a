/// All rows of a step written out: how an impulse on each changes the speed of every other.
///
///   A = J M^-1 J^T,   A_ij = J_i (M^-1 J_j^T): 0 where row i and row j have no moving body in common
#pragma once

#include "pushback/chapters/01_velocity_constraint/row.h"
#include "pushback/engine/direct/contact_problem.h"

namespace pushback {

/// 1/kg, a row and a column for each of `rows`. `softness`, 1/kg, is added on the diagonal: of each row, or none.
SparseMatrix matrix_of(const Rows& rows, const std::vector<Real>& softness = {});

/// J V + b of each row, m/s: what A lambda has to make up for.
Vector speeds_of(const Rows& rows);

/// Projected Gauss-Seidel, one row:   l_i <- clamp(l_i - (A l + b)_i / A_ii, lo, hi)
///
/// Over all rows in turn this is sequential impulses: there JV is kept in the bodies' velocities, here it is added up from A.
void project_row(const SparseMatrix& a, const Vector& b, Eigen::Index i, double lo, double hi, Vector& impulses);

/// The contacts of a world as a problem for any solver, q = JV as the bodies move now: after World::begin_step, that of the
/// step. Friction is each contact's own; r_n is along its normal, r_t along tangents_of.
ContactProblem problem_of(World& world);

/// The same of a solver's rows: the first contacts.size() are the normals, tangents may follow, two a contact. q = JV + b.
/// A contact without tangents among them is without friction.
ContactProblem problem_of(const Contacts& contacts, const Rows& rows);

/// Where each of those rows stands in that problem: of each contact the normal comes first, then its tangents.
std::vector<Eigen::Index> places_in_problem(const Contacts& contacts, const Rows& rows);

}  // namespace pushback
