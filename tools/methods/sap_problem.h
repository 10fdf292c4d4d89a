/// The convex function of all velocities whose minimum is a step of SAP, and Newton's method that finds it: laws of contacts and joints
/// that are gradients of convex functions of the velocities.
#pragma once

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace pushback {

/// The result of a law of N rows at a velocity u (m/s, or rad/s): its part of the cost, and two derivatives of that.
template <int N>
struct SapAnswer {
  Eigen::Matrix<double, N, 1> impulse;  ///< gamma = -dl/du, N s
  Eigen::Matrix<double, N, N> slope;    ///< -dgamma/du, kg: symmetric, positive semi-definite
  double cost;                          ///< l(u), J
};

/// A contact. Vectors are in world axes; n is a unit vector, and its tangents need no names, as R is the same along each:
///
///   gamma = the nearest to y within  |gamma_t| <= mu gamma_n,  distances measured by R = R_t (1 - n n^T) + R_n n n^T
///   y = -R^-1 (u - v n),   l(u) = gamma^T R gamma / 2
///
///   sticks    |y_t| <= mu y_n                    gamma = y
///   parts     R_n y_n + mu R_t |y_t| <= 0        gamma = 0
///   slides    else                               gamma_n = (R_n y_n + mu R_t |y_t|) / (R_n + mu^2 R_t),  gamma_t = mu gamma_n y_t / |y_t|
///
/// It sticks with a slip of R_t gamma_t, and is pressed closed up to R_n gamma_n. What slides has u_n - v + R_n gamma_n = mu |u_t| and
/// not 0: this is Coulomb's law relaxed, see tools/measure/study/relaxed_law.h.
///   A. Castro, F. Permenter, X. Han, "An Unconstrained Convex Formulation of Compliant Contact", IEEE Transactions on Robotics, 2022
///
/// Lagged, friction is bounded by an impulse n_0 that is known before, and regularised. Normal and tangent are then two problems:
///
///   gamma_n = max(0, y_n),  gamma_t = -mu n_0 u_t / s,  s = sqrt(|u_t|^2 + e^2)       l(u) = R_n gamma_n^2 / 2 + mu n_0 (s - e)
///
///   A. Castro, X. Han, J. Masterjohn, "Irrotational Contact Fields", arXiv:2312.03908, 2024
struct SapContactLaw {
  Eigen::Vector3d n;
  double mu;
  double r_t, r_n;                    ///< 1/kg, above 0
  double wanted;                      ///< v, m/s, separating
  std::optional<double> lagged = {};  ///< n_0, N s
  double slow = 0;                    ///< e, m/s: a lagged contact sticks below it

  bool sticks(const Eigen::Vector3d& u) const {
    if (lagged) return mu > 0 && (u - n.dot(u) * n).norm() <= slow;
    const auto [y_n, y_t] = parts(u);
    return mu > 0 && y_t.norm() <= mu * y_n;
  }
  SapAnswer<3> at(const Eigen::Vector3d& u) const {
    const auto [y_n, y_t] = parts(u);
    const double length = y_t.norm();
    const Eigen::Matrix3d along = n * n.transpose(), across = Eigen::Matrix3d::Identity() - along;
    if (lagged) {
      const Eigen::Vector3d u_t = across * u;
      const double most = mu * *lagged, soft = std::hypot(u_t.norm(), slow), pressed = std::max(0.0, y_n);
      return {pressed * n - most / soft * u_t,
              (pressed > 0 ? 1 / r_n : 0) * along + most / soft * (across - u_t * u_t.transpose() / (soft * soft)),
              r_n * pressed * pressed / 2 + most * (soft - slow)};
    }
    if (mu > 0 && length <= mu * y_n)
      return {y_n * n + y_t, along / r_n + across / r_t, (r_n * y_n * y_n + r_t * length * length) / 2};
    const double sum = r_n + mu * mu * r_t, gamma_n = (r_n * y_n + mu * r_t * length) / sum;
    if (gamma_n <= 0) return {Eigen::Vector3d::Zero(), Eigen::Matrix3d::Zero(), 0};
    const Eigen::Vector3d t = length > 0 ? Eigen::Vector3d(y_t / length) : Eigen::Vector3d::Zero();
    const Eigen::Vector3d edge = n + mu * t;  // gamma lies on it, and changes along it by `edge . du` alone
    Eigen::Matrix3d slope = edge * edge.transpose() / sum;
    if (length > 0) slope += mu * gamma_n / (length * r_t) * (across - t * t.transpose());
    return {gamma_n * edge, slope, sum * gamma_n * gamma_n / 2};
  }

 private:
  struct Parts {
    double n;
    Eigen::Vector3d t;
  };
  Parts parts(const Eigen::Vector3d& u) const {
    const double u_n = n.dot(u);
    return {(wanted - u_n) / r_n, -(u - u_n * n) / r_t};
  }
};

/// An equation of a joint: gamma = -(u - v) / R, but within its bounds;   l(u) = R (gamma y - gamma^2 / 2).
struct SapRowLaw {
  double r;       ///< 1/kg or 1/(kg m^2), above 0
  double wanted;  ///< v, m/s or rad/s
  double lo, hi;  ///< N s or N m s

  SapAnswer<1> at(const Eigen::Matrix<double, 1, 1>& u) const {
    const double y = (wanted - u[0]) / r, gamma = std::clamp(y, lo, hi);
    return {Eigen::Matrix<double, 1, 1>(gamma), Eigen::Matrix<double, 1, 1>(gamma == y ? 1 / r : 0),
            r * gamma * (y - gamma / 2)};
  }
};

/// Rows between two bodies, u = J_a v_a + J_b v_b + rest. A body is a place in the problem, or `nothing_moves`.
template <int N, class Law>
struct SapBond {
  using Jacobian = Eigen::Matrix<double, N, 6>;
  using Rows = Eigen::Matrix<double, N, 1>;

  int a, b;
  Jacobian j_a, j_b;
  Rows rest;  ///< m/s: of a body that cannot move freely, such as a conveyor or one moved by hand
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
///   A. Castro, F. Permenter, X. Han, as above; the root of l': Press et al., Numerical Recipes, 9.4, "rtsafe"
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
  static void each_bond(auto& problem, const auto& visit) {
    for (auto& contact : problem.contacts) visit(contact);
    for (auto& row : problem.rows) visit(row);
  }
  static void each_body(const auto& bond, const auto& visit) {
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
