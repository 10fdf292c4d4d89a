#include "pushback/chapters/17_direct_contacts/smoothed_newton.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "pushback/chapters/17_direct_contacts/newton_system.h"

namespace pushback {

namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

/// x and z of one contact, and dz = -slope dx along their common curve.
struct Rounded {
  Vector3d x, z;
  Matrix3d slope, inverse;

  Rounded(const Vector3d& y, double t) {
    const double tangential = std::hypot(y[1], y[2]);
    const Vector2d way = tangential > 0 ? Vector2d(y.tail<2>() / tangential) : Vector2d(1, 0);
    const std::array eigenvalues{y[0] - tangential, y[0] + tangential};
    std::array<double, 2> xs, zs;
    for (std::size_t i = 0; i < 2; ++i) {  // the smaller one from the larger: nothing cancels
      const double larger = (std::abs(eigenvalues[i]) + std::hypot(eigenvalues[i], 2 * t)) / 2;
      const double smaller = larger > 0 ? t * (t / larger) : 0;
      xs[i] = eigenvalues[i] > 0 ? larger : smaller;
      zs[i] = eigenvalues[i] > 0 ? smaller : larger;
    }
    x << (xs[0] + xs[1]) / 2, (xs[1] - xs[0]) / 2 * way;
    z << (zs[0] + zs[1]) / 2, (zs[1] - zs[0]) / 2 * way;
    const bool on_axis = tangential < 1e-12 * (std::abs(y[0]) + t);
    const double aside = on_axis ? ratio(xs[1], zs[1]) : ratio(xs[1] - xs[0], zs[0] - zs[1]);
    const Vector3d across(0, -way[1], way[0]);
    const std::array slopes{ratio(xs[0], zs[0]), ratio(xs[1], zs[1]), aside};
    const std::array directions{Vector3d(std::sqrt(0.5) * Vector3d(1, -way[0], -way[1])),
                                Vector3d(std::sqrt(0.5) * Vector3d(1, way[0], way[1])), across};
    slope.setZero();
    inverse.setZero();
    for (std::size_t i = 0; i < 3; ++i) {
      slope += slopes[i] * directions[i] * directions[i].transpose();
      inverse += 1 / slopes[i] * directions[i] * directions[i].transpose();
    }
  }

 private:
  /// Bounded: a contact that sticks gives way by 1e-7 W at least, so that B^T D^-1 B keeps the digits of the masses beside it.
  static double ratio(double of_x, double of_z) { return of_x > 0 ? std::clamp(of_z / of_x, 1e-7, 1e12) : 1e12; }
};

/// The problem in x, z and y, speeds as parts of the mean of q.
class Smoothed {
 public:
  Smoothed(const ContactProblem& problem, const SparseRows& factor) : scale_(problem.q.size()) {
    const Vector units = unit_scales(problem);
    for (Index c = 0; c < problem.contacts(); ++c) {
      const double mu = problem.mu[c];  // without friction, the tangents are left out: their rows become 0
      scale_.segment<3>(3 * c) << 1 / (mu > 0 ? mu * units[c] : units[c]),
          Vector2d::Constant(mu > 0 ? 1 / units[c] : 0);
    }
    w_ = scale_.asDiagonal() * problem.w * scale_.asDiagonal();
    q_ = scale_.cwiseProduct(problem.q);
    const double mean = q_.norm() / std::sqrt(static_cast<double>(problem.contacts()));
    unit_ = mean > 0 ? mean : 1;
    q_ /= unit_;
    system = newton_system(w_, factor.rows() > 0 ? SparseRows(scale_.asDiagonal() * factor) : SparseRows());
  }
  std::unique_ptr<NewtonSystem> system;
  double t = 1;

  /// r, with the kinks: every one is within its cone.
  Vector impulses(const Vector& y) const {
    Vector x(y.size());
    for (Index c = 0; 3 * c < y.size(); ++c) x.segment<3>(3 * c) = Rounded(y.segment<3>(3 * c), 0).x;
    return unit_ * scale_.cwiseProduct(x);
  }
  /// W x + q - z + |z_t| n.
  Vector f(const Vector& y) const {
    Vector x(y.size()), rest(y.size());
    for (Index c = 0; 3 * c < y.size(); ++c) {
      const Rounded at(y.segment<3>(3 * c), t);
      x.segment<3>(3 * c) = at.x;
      rest.segment<3>(3 * c) = -at.z;
      rest[3 * c] += at.z.tail<2>().norm();
    }
    return w_ * x + q_ + rest;
  }
  /// The change of y that f' says; not finite where f' cannot be inverted.
  Vector step(const Vector& y, const Vector& f_of_y) {
    std::vector<DiagonalBlock> blocks;
    std::vector<Matrix3d> slopes;
    for (Index c = 0; 3 * c < y.size(); ++c) {
      const Rounded at(y.segment<3>(3 * c), t);
      const double slip = at.z.tail<2>().norm();
      Matrix3d of_slip = Matrix3d::Zero();  // d(|z_t| n) by dz
      if (slip > 0) of_slip.block<1, 2>(0, 1) = at.z.tail<2>().transpose() / slip;
      blocks.push_back({(Matrix3d::Identity() - of_slip) * at.slope, at.inverse * (Matrix3d::Identity() + of_slip)});
      slopes.push_back(at.slope);
    }
    if (!system->factorize(blocks)) return Vector::Constant(y.size(), std::nan(""));
    Vector dx = system->solve(-f_of_y);
    for (int refined = 0; refined < 2; ++refined) {  // contacts that stick make the matrix of bodies ill-conditioned
      Vector rest = -f_of_y - w_ * dx;
      for (Index c = 0; 3 * c < y.size(); ++c)
        rest.segment<3>(3 * c) -= blocks[static_cast<std::size_t>(c)].d * dx.segment<3>(3 * c);
      dx += system->solve(rest);
    }
    for (Index c = 0; 3 * c < y.size(); ++c) {  // dy = dx - dz
      const Vector3d dz = -slopes[static_cast<std::size_t>(c)] * dx.segment<3>(3 * c);
      dx.segment<3>(3 * c) -= dz;
    }
    return dx;
  }

 private:
  SparseRows w_;
  Vector q_, scale_;  // r = unit scale x
  double unit_ = 1;
};

/// A step halved until |f| falls; false where it does not.
bool shorten(const Smoothed& problem, const Vector& step, Vector& y, Vector& f) {
  if (!step.allFinite()) return false;
  for (double part = 1; part > 1e-4; part /= 2) {
    const Vector tried = y + part * step, f_of_tried = problem.f(tried);
    if (!(f_of_tried.norm() <= (1 - 1e-4 * part) * f.norm())) continue;
    y = tried;
    f = f_of_tried;
    return true;
  }
  return false;
}

}  // namespace

SmoothedSolution solve_smoothed(const ContactProblem& problem, const SmoothedLimits& limits, const SparseRows& factor) {
  SmoothedSolution best;
  best.r = Vector::Zero(problem.q.size());
  best.residual = relative_residual(problem, best.r);
  if (best.residual <= limits.tolerance) return best;
  Smoothed smoothed(problem, factor);
  const double near = std::sqrt(static_cast<double>(problem.contacts()));  // times t: where t may fall again
  double fall = 0.1;
  int failed = 0;
  Vector y = Vector::Zero(problem.q.size()), f = smoothed.f(y);
  while (best.residual > limits.tolerance && failed < 8 && best.systems < limits.systems && best.work < limits.work) {
    const Vector step = smoothed.step(y, f);
    ++best.systems;
    best.work = smoothed.system->work;
    if (shorten(smoothed, step, y, f)) {
      const Vector r = smoothed.impulses(y);
      if (const double residual = relative_residual(problem, r); residual < best.residual) {
        best.residual = residual;
        best.r = r;
      }
      if (f.norm() > near * smoothed.t) continue;
      smoothed.t = std::max(1e-15, smoothed.t * fall);
    } else {
      ++failed;
      smoothed.t *= 10;
      fall = std::sqrt(fall);
    }
    f = smoothed.f(y);
  }
  best.entries = smoothed.system->entries;
  best.fill = smoothed.system->fill;
  return best;
}

}  // namespace pushback
