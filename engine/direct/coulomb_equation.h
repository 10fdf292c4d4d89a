/// Coulomb's law of one contact as an equation f = 0 (Alart and Curnier), with the derivatives for Newton's method.
#pragma once

#include "pushback/engine/direct/sweeps.h"

namespace pushback {

/// f(r, u) of one contact and its derivatives. The equation is written in proximal_newton.h.
struct CoulombEquation {
  Eigen::Vector3d f;
  Eigen::Matrix3d df_du = Eigen::Matrix3d::Zero(), df_dr = Eigen::Matrix3d::Zero();

  CoulombEquation(const ContactBlock& at, double mu, const Eigen::Vector3d& r, const Eigen::Vector3d& u) {
    using Eigen::Matrix2d;
    using Eigen::Vector2d;
    const double a = at.w(0, 0) > 0 ? 1 / at.w(0, 0) : 1, b = at.larger_eigenvalue > 0 ? 1 / at.larger_eigenvalue : 1;
    const double normal = r[0] - a * u[0];
    if (normal <= 0) {  // open: r = 0
      f = r;
      df_dr.setIdentity();
      return;
    }
    f[0] = a * u[0];
    df_du(0, 0) = a;
    const Vector2d t = r.tail<2>() - b * u.tail<2>();
    const double radius = mu * normal, length = t.norm();
    if (length <= radius) {  // sticks: u = 0
      f.tail<2>() = b * u.tail<2>();
      df_du(1, 1) = df_du(2, 2) = b;
      return;
    }
    const Vector2d way = t / length;  // slides: r_t = radius way
    const Matrix2d turn = radius / length * (Matrix2d::Identity() - way * way.transpose());
    f.tail<2>() = r.tail<2>() - radius * way;
    df_dr.bottomRightCorner<2, 2>() = Matrix2d::Identity() - turn;
    df_du.bottomRightCorner<2, 2>() = b * turn;
    df_dr.bottomLeftCorner<2, 1>() = -mu * way;
    df_du.bottomLeftCorner<2, 1>() = mu * a * way;
  }
};

}  // namespace pushback
