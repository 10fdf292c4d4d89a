/// All contacts of one step as one problem, and the errors of approximate solutions.
///
///   u = W r + q        W = J M^-1 J^T of all rows, symmetric and positive semi-definite,  q = J V before any impulse
///   s = u + mu |u_t| n,   r in K = {|r_t| <= mu r_n},   s in K* = {s_n >= mu |s_t|},   r . s = 0, contact by contact
///
/// K* is the dual cone of K: all s with r . s >= 0 for every r in K. Because s_t = u_t, s is in K* if and only if u_n >= 0. If
/// W is positive definite, a solution r exists for every q and every mu, but it need not be unique. If W is singular, whether a
/// solution exists depends on q: see chapter 16's page.
/// r (N s) and u (m/s) have three components per contact, first along the normal, then along two tangents.
///   De Saxce, Feng, 1998: with mu |u_t| added to the normal speed, Coulomb's law is one complementarity of two cones.
/// All numbers are double, whatever Real is, because solvers reach residuals of 1e-12.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <vector>

namespace pushback {

using Vector = Eigen::VectorXd;
using SparseMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

struct ContactProblem {
  SparseMatrix w;  ///< 1/kg, 3 n x 3 n; of each diagonal 3 x 3 block all nine are stored
  Vector q;        ///< m/s, 3 n
  Vector mu;       ///< n, each 0 or more

  Eigen::Index contacts() const { return mu.size(); }
  /// u, m/s.
  Vector speeds(const Vector& r) const { return w * r + q; }
};

/// The point of the cone |r_t| <= mu r_n that is nearest to r. For mu = 0 the cone is the ray r_n >= 0, r_t = 0.
Eigen::Vector3d projected_to_cone(const Eigen::Vector3d& r, double mu);

/// || r - Pi(r - (u + mu |u_t| n)) || / ||q||, the error of the natural map, undivided if q is 0. It is 0 if and only if r is
/// a solution. Acary, Bremond and Huber, 2018, use this measure. Because it adds N s and m/s, its value depends on the units: a
/// scene in grams has another residual than the same scene in kilograms.
double relative_residual(const ContactProblem& problem, const Vector& r);
/// The same, if u is already known.
using VectorView = Eigen::Ref<const Vector>;
double relative_residual(const VectorView& r, const VectorView& u, const VectorView& q, const VectorView& mu);

/// The same error in coordinates that have one unit, sqrt(J): each contact's r is multiplied by sqrt(d), its u and q are
/// divided by sqrt(d), where d, 1/kg, is the mean of the three diagonal entries of its block of W.
///
/// Because one d scales the normal and the tangents of a contact, the cone remains the same. d does not depend on the choice of
/// tangents. Units of mass and speed cancel against q, so the value does not depend on them. A contact that no impulse moves
/// (its block of W is 0) gets the largest d of all contacts.
double unitless_residual(const ContactProblem& problem, const Vector& r);

/// sqrt(d) of each contact.
Vector unit_scales(const ContactProblem& problem);

/// The 3 x 3 blocks of W on its diagonal.
std::vector<Eigen::Matrix3d> diagonal_blocks(const ContactProblem& problem);

/// The largest |w_ij - w_ji|, as a fraction of the largest |w_ij|.
double asymmetry(const ContactProblem& problem);

}  // namespace pushback
