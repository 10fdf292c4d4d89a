/// All contacts of one step as one problem, and how far impulses are from solving it.
///
///   u = W r + q        W = J M^-1 J^T of all rows, symmetric, positive semi-definite; q: JV before any impulse
///   s = u + mu |u_t| n,   r in K = {|r_t| <= mu r_n},   s in K* = {s_n >= mu |s_t|},   r . s = 0, contact by contact
///
/// K* is the dual cone of K: all s with r . s >= 0 for every r in K. As s_t = u_t, s in K* says u_n >= 0 and nothing else.
/// Where W is positive definite, an r exists for every q and every mu, not always a single one. Where W is singular, it
/// depends on q whether any does: chapter 16's page says on what.
/// r and u have three numbers a contact: along the normal, and along two tangents. N s and m/s.
///   De Saxce, Feng, 1998: with mu |u_t| added to the normal speed, Coulomb's law is one complementarity of two cones.
/// All in double, whatever Real is: residuals of 1e-12 are asked for.
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

/// || r - Pi(r - (u + mu |u_t| n)) || / ||q||, the natural map's error; not divided where q is 0. 0 exactly where r solves.
/// Acary, Bremond and Huber, 2018, measure so. It adds N s and m/s, as the map does: r moves by 1 N s for 1 m/s. So its value depends on the units:
/// of the same scene in grams it is another one.
double relative_residual(const ContactProblem& problem, const Vector& r);
/// The same where u is known already.
using VectorView = Eigen::Ref<const Vector>;
double relative_residual(const VectorView& r, const VectorView& u, const VectorView& q, const VectorView& mu);

/// The same error in coordinates that have one unit: each contact's r times sqrt(d), its u and q divided by sqrt(d), where
/// d, 1/kg, is the mean of the three diagonal entries of its block of W. All are then in sqrt(J).
///
/// One number d a contact scales normal and tangents alike, so that the cone stays the same cone; d does not depend on the
/// choice of tangents either. Units of mass and of speed cancel against q: the value is the same in all. A contact that no
/// impulse moves, W = 0 there, has the largest d of all.
double unitless_residual(const ContactProblem& problem, const Vector& r);

/// sqrt(d) of each contact.
Vector unit_scales(const ContactProblem& problem);

/// The 3 x 3 blocks of W on its diagonal.
std::vector<Eigen::Matrix3d> diagonal_blocks(const ContactProblem& problem);

/// The largest |w_ij - w_ji|, as a part of the largest |w_ij|.
double asymmetry(const ContactProblem& problem);

}  // namespace pushback
