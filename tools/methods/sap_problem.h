/// The convex function of all velocities whose minimum is a step of SAP, and Newton's method that finds it.
#pragma once

#include <Eigen/SparseCholesky>
#include <vector>

#include "pushback/tools/methods/sap_laws.h"

namespace pushback {

/// Rows between two bodies, u = J_a v_a + J_b v_b + rest. A body is a place in the problem, or `nothing_moves`.
template <int N, class Law>
struct SapBond {
  using Jacobian = Eigen::Matrix<double, N, 6>;
  using Rows = Eigen::Matrix<double, N, 1>;

  int a, b;
  Jacobian j_a, j_b;
  Rows rest;  ///< m/s: of what cannot move by itself, a conveyor or a body that is moved by hand
  Law law;

  Rows u = Rows::Zero(), change = Rows::Zero();  ///< in the search: here, and for the whole of a Newton step

  /// J v.
  Rows along(const Eigen::VectorXd& v) const {
    Rows sum = Rows::Zero();
    if (a >= 0) sum += j_a * v.segment<6>(6 * Eigen::Index{a});
    if (b >= 0) sum += j_b * v.segment<6>(6 * Eigen::Index{b});
    return sum;
  }
};

///   l(v) = (v - v*)^T M (v - v*) / 2  +  sum of l_i(J_i v)          v: 6 numbers a body, its velocity and its spin
///
/// l is strictly convex, and has one minimum. Its gradient and its Hessian are
///
///   M (v - v*) - sum of J_i^T gamma_i,     H = M + sum of J_i^T G_i J_i     gamma_i, G_i: a law's `impulse` and `slope`
///
/// H has a block of 6 x 6 for each body and for each pair that touches or is joined, however many contacts press on it. A step of
/// Newton's method goes along -H^-1 gradient as far as l falls, until l' is 1e-4 of what it was. l' along that line is computed
/// from changes of u, without H.
///   A. Castro, F. Permenter, X. Han, as in sap_laws.h; the root of l': Press et al., Numerical Recipes, 9.4, "rtsafe"
class SapProblem {
 public:
  using Vector = Eigen::VectorXd;
  using Vec6 = Eigen::Matrix<double, 6, 1>;
  using Mat6 = Eigen::Matrix<double, 6, 6>;
  using Contact = SapBond<3, SapContactLaw>;
  using Row = SapBond<1, SapRowLaw>;
  static constexpr int nothing_moves = -1;

  std::vector<Contact> contacts;
  std::vector<Row> rows;

  void clear();
  /// `mass`: kg and kg m^2, world axes; `free`: v*, as forces alone leave it. Returns its place.
  int add(const Mat6& mass, const Vec6& free);
  const Vector& free() const { return free_; }

  double cost(const Vector& v) const;  ///< l, J

  /// From v to the minimum: until  |D gradient| <= tolerance max(|D M v|, |D sum of J^T gamma|)  with D = diag(M)^-1/2, or after
  /// `most_steps`. Returns the number of Newton steps, each of which solves a linear system.
  int minimise(Vector& v, double tolerance, int most_steps);

 private:
  template <class Visit>
  static void each_body(const auto& bond, const Visit& visit) {
    if (bond.a != nothing_moves) visit(bond.a, bond.j_a);
    if (bond.b != nothing_moves) visit(bond.b, bond.j_b);
  }
  Vector times_mass(const Vector& v) const;
  Vector pushes(const Vector& v) const;  // sum of J^T gamma
  void assemble(const Vector& v);
  bool is_there(const Vector& v, Vector& gradient, double tolerance) const;
  double best_part(const Vector& v, const Vector& change, const Vector& gradient);

  std::vector<Mat6> masses_;
  Vector free_;
  Eigen::SparseMatrix<double> h_;  // its lower triangle, and whole blocks on the diagonal
};

}  // namespace pushback
