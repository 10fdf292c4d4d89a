/// All contacts of one step as one problem, and how far impulses are from solving it.
///
///   u = W r + q        W = J M^-1 J^T of all rows, symmetric, positive semi-definite; q: JV before any impulse
///   |r_t| <= mu r_n,   u_n + mu |u_t| >= 0 ...: r in the cone K, s = u + mu |u_t| n in its dual, and r . s = 0
///
/// r and u have three numbers a contact: along the normal, and along two tangents. N s and m/s.
///   De Saxce, Feng, 1998: with mu |u_t| added to the normal speed, Coulomb's law is one complementarity of two cones.
/// All in double, whatever Real is: residuals of 1e-12 are asked for.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <vector>

namespace pushback {

using Vector = Eigen::VectorXd;
using SparseRows = Eigen::SparseMatrix<double, Eigen::RowMajor>;

struct ContactProblem {
  SparseRows w;  ///< 1/kg, 3 n x 3 n; of each diagonal 3 x 3 block all nine are stored
  Vector q;      ///< m/s, 3 n
  Vector mu;     ///< n, each 0 or more

  Eigen::Index contacts() const { return mu.size(); }
  /// u, m/s.
  Vector speeds(const Vector& r) const { return w * r + q; }
};

/// The point of the cone |r_t| <= mu r_n that is nearest to r.
Eigen::Vector3d projected_to_cone(const Eigen::Vector3d& r, double mu);

/// || r - P_K(r - (u + mu |u_t| n)) || / ||q||, the natural map's error; not divided where q is 0. 0 exactly where r solves.
/// Siconos measures so. It adds N s and m/s, as the map does: r moves by 1 N s for 1 m/s.
double relative_residual(const ContactProblem& problem, const Vector& r);

/// The 3 x 3 blocks of W on its diagonal.
std::vector<Eigen::Matrix3d> diagonal_blocks(const ContactProblem& problem);

/// The largest |w_ij - w_ji|, as a part of the largest |w_ij|.
double asymmetry(const ContactProblem& problem);

}  // namespace pushback
