/// Laws of contacts and joints that are gradients of convex functions of the velocities.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace pushback {

/// What a law of N rows says at a velocity u (m/s, or rad/s): its part of the cost, and two derivatives of that.
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
struct SapContactLaw {
  Eigen::Vector3d n;
  double mu;
  double r_t, r_n;  ///< 1/kg, above 0
  double wanted;    ///< v, m/s, separating

  bool sticks(const Eigen::Vector3d& u) const {
    const auto [y_n, y_t] = parts(u);
    return mu > 0 && y_t.norm() <= mu * y_n;
  }
  SapAnswer<3> at(const Eigen::Vector3d& u) const {
    const auto [y_n, y_t] = parts(u);
    const double length = y_t.norm();
    const Eigen::Matrix3d along = n * n.transpose(), across = Eigen::Matrix3d::Identity() - along;
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

}  // namespace pushback
