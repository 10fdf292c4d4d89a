#include "pushback/engine/direct/smoothed_newton.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "pushback/engine/direct/newton_system.h"

namespace pushback {

namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

/// The smoothed x and z of one contact, and the derivative along their common curve, dz = -slope dx.
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
  /// Bounded below, so that D^-1 of a sticking contact is not so large that B^T D^-1 B loses the digits of the masses that are
  /// added to it.
  static double ratio(double of_x, double of_z) { return of_x > 0 ? std::clamp(of_z / of_x, 1e-7, 1e12) : 1e12; }
};

/// The problem in x, z and y. Speeds are divided by the root mean square of q.
class Smoothed {
 public:
  Smoothed(const ContactProblem& problem, const SparseMatrix& factor) : scale_(problem.q.size()) {
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
    system = std::make_unique<NewtonSystem>(
        w_, factor.rows() > 0 ? SparseMatrix(scale_.asDiagonal() * factor) : SparseMatrix());
  }
  std::unique_ptr<NewtonSystem> system;
  double t = 1;

  /// r by the exact law, so each contact's impulse is inside of its cone.
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
  /// The Newton step. Not finite if f' is singular.
  Vector step(const Vector& y, const Vector& f_of_y) {
    std::vector<DiagonalBlock> blocks;
    std::vector<Matrix3d> with_slip;  // (I - of_slip)^-1
    for (Index c = 0; 3 * c < y.size(); ++c) {
      const Rounded at(y.segment<3>(3 * c), t);
      const double slip = at.z.tail<2>().norm();
      Matrix3d of_slip = Matrix3d::Zero();  // d(|z_t| n) by dz; its square is 0
      if (slip > 0) of_slip.block<1, 2>(0, 1) = at.z.tail<2>().transpose() / slip;
      with_slip.emplace_back(Matrix3d::Identity() + of_slip);
      blocks.push_back({(Matrix3d::Identity() - of_slip) * at.slope, at.inverse * with_slip.back()});
    }
    if (!system->factorize(blocks)) return Vector::Constant(y.size(), std::nan(""));
    const Vector dx = system->solve(-f_of_y);
    // dy = dx - dz, with dz from W dx - dz + of_slip dz = -f. From dz = -slope dx it has no digits: slopes reach 1e12.
    Vector dz = f_of_y + w_ * dx;
    for (Index c = 0; 3 * c < y.size(); ++c)
      dz.segment<3>(3 * c) = (with_slip[static_cast<std::size_t>(c)] * dz.segment<3>(3 * c)).eval();
    return dx - dz;
  }

 private:
  SparseMatrix w_;
  Vector q_, scale_;  // r = unit scale x
  double unit_ = 1;
};

/// Halves the step until |f| falls. Returns false if it does not.
bool shorten(const Smoothed& problem, const Vector& step, Vector& y, Vector& f) {
  if (!step.allFinite()) return false;
  for (double part = 1; part > 1e-2; part /= 2) {
    const Vector tried = y + part * step, f_of_tried = problem.f(tried);
    if (!(f_of_tried.norm() <= (1 - 1e-4 * part) * f.norm())) continue;
    y = tried;
    f = f_of_tried;
    return true;
  }
  return false;
}

/// Follows the path of y as t decreases, within the limits.
class Path {
 public:
  Path(const ContactProblem& problem, const SmoothedLimits& limits, const SparseMatrix& factor, SmoothedSolution& best)
      : problem_(problem), limits_(limits), smoothed_(problem, factor), best_(best) {}

  void follow() {
    Vector y = Vector::Zero(problem_.q.size());
    reach(1, y);  // or as near as it gets
    double t = 1, fall = 0.1;
    while (goes_on() && fall < 0.99 && t > least) {
      Vector farther = y;
      if (reach(std::max(least, fall * t), farther)) {
        y = farther;
        t = smoothed_.t;
        fall = std::max(0.1, fall * fall);
      } else {
        fall = std::sqrt(fall);  // once more from the last point, by a shorter way
      }
    }
    best_.entries = smoothed_.system->entries;
    best_.fill = smoothed_.system->fill;
  }

 private:
  static constexpr int most_systems = 12;  // for one t: if it takes more, a smaller decrease of t is cheaper
  static constexpr double least = 1e-15;   // t: below it, only rounding changes
  static constexpr double near = 0.1;      // |f| of a contact as a fraction of t

  bool goes_on() const {
    return best_.residual > limits_.tolerance && best_.systems < limits_.systems && best_.work < limits_.work;
  }
  /// From y to the point of t, by Newton's method.
  bool reach(double t, Vector& y) {
    smoothed_.t = t;
    const double enough = near * t * std::sqrt(static_cast<double>(problem_.contacts()));
    Vector f = smoothed_.f(y);
    for (int i = 0; i < most_systems && f.norm() > enough && goes_on(); ++i) {
      const Vector step = smoothed_.step(y, f);
      ++best_.systems;
      best_.work = smoothed_.system->work;
      if (!shorten(smoothed_, step, y, f)) break;
      keep(smoothed_.impulses(y));
    }
    return f.norm() <= enough;
  }
  void keep(const Vector& r) {
    const double residual = relative_residual(problem_, r);
    if (!(residual < best_.residual)) return;
    best_.residual = residual;
    best_.r = r;
  }

  const ContactProblem& problem_;
  const SmoothedLimits limits_;
  Smoothed smoothed_;
  SmoothedSolution& best_;
};

}  // namespace

SmoothedSolution solve_smoothed(const ContactProblem& problem, const SmoothedLimits& limits,
                                const SparseMatrix& factor) {
  SmoothedSolution best;
  best.r = Vector::Zero(problem.q.size());
  best.residual = relative_residual(problem, best.r);
  if (best.residual > limits.tolerance) Path(problem, limits, factor, best).follow();
  return best;
}

}  // namespace pushback
