/// Sweeps over a contact problem, as in chapters 06 and 08, but written for W instead of rows.
///
/// A sweep solves each contact by itself, in turn. First all normals,
///
///   r_n <- max(0, r_n - u_n / W_nn),     then all tangents for the present u_t, within mu r_n
///
/// PyramidStep, ScaledBackStep and ConeStep differ only in how they solve the tangents.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "pushback/engine/direct/contact_problem.h"

namespace pushback {

/// The block of W of one contact.
struct ContactBlock {
  Eigen::Matrix3d w;
  double larger_eigenvalue;  ///< of the tangents' 2 x 2 block, 1/kg

  explicit ContactBlock(const Eigen::Matrix3d& block)
      : w(block),
        larger_eigenvalue((w(1, 1) + w(2, 2)) / 2 + std::hypot((w(1, 1) - w(2, 2)) / 2, (w(1, 2) + w(2, 1)) / 2)) {}
};

/// Solves each tangent by itself within its own bound, as chapter 06's pyramid.
struct PyramidStep {
  static void step(const ContactBlock& at, double radius, Eigen::Vector2d u, Eigen::Vector2d& r) {
    for (Eigen::Index i = 0; i < 2; ++i) {
      const double k = at.w(1 + i, 1 + i);
      if (k <= 0) continue;  // no impulse moves it
      const double total = std::clamp(r[i] - u[i] / k, -radius, radius);
      u += (total - r[i]) * at.w.block<2, 1>(1, 1 + i);
      r[i] = total;
    }
  }
};

inline Eigen::Vector2d projected_to_disc(const Eigen::Vector2d& r, double radius) {
  const double length = r.norm();
  return length > radius ? Eigen::Vector2d(r * (radius / length)) : r;
}

/// Solves both tangents at once. An impulse outside the disc is scaled back to it, as in chapter 08's near miss.
struct ScaledBackStep {
  static void step(const ContactBlock& at, double radius, const Eigen::Vector2d& u, Eigen::Vector2d& r) {
    const Eigen::Matrix2d k = at.w.bottomRightCorner<2, 2>();
    const double determinant = k(0, 0) * k(1, 1) - k(0, 1) * k(1, 0);
    if (determinant <= 0) return;
    const Eigen::Vector2d solved(k(1, 1) * u[0] - k(0, 1) * u[1], k(0, 0) * u[1] - k(1, 0) * u[0]);
    r = projected_to_disc(r - solved / determinant, radius);
  }
};

/// Takes a step of the same size for both tangents, projected to the disc, as chapter 08's cone. If the step changes nothing,
/// Coulomb's law holds.
struct ConeStep {
  static void step(const ContactBlock& at, double radius, const Eigen::Vector2d& u, Eigen::Vector2d& r) {
    if (at.larger_eigenvalue > 0) r = projected_to_disc(r - u / at.larger_eigenvalue, radius);
  }
};

/// Keeps a reference to the problem, which must outlive it.
template <class TangentStep>
class Sweeper {
 public:
  explicit Sweeper(const ContactProblem& problem) : problem_(problem) {
    for (const Eigen::Matrix3d& block : diagonal_blocks(problem)) blocks_.emplace_back(block);
  }
  void sweep(Vector& r) const {
    for (Eigen::Index c = 0; c < problem_.contacts(); ++c) {
      const double own = block(c).w(0, 0);
      if (own > 0) r[3 * c] = std::max(0.0, r[3 * c] - speed(3 * c, r) / own);
    }
    for (Eigen::Index c = 0; c < problem_.contacts(); ++c) {
      const Eigen::Vector2d u(speed(3 * c + 1, r), speed(3 * c + 2, r));
      Eigen::Vector2d tangents = r.segment<2>(3 * c + 1);
      TangentStep::step(block(c), problem_.mu[c] * r[3 * c], u, tangents);
      r.segment<2>(3 * c + 1) = tangents;
    }
  }

 private:
  const ContactBlock& block(Eigen::Index c) const { return blocks_[static_cast<std::size_t>(c)]; }
  /// One row of W r + q.
  double speed(Eigen::Index row, const Vector& r) const {
    double u = problem_.q[row];
    for (SparseMatrix::InnerIterator it(problem_.w, row); it; ++it) u += it.value() * r[it.col()];
    return u;
  }

  const ContactProblem& problem_;
  std::vector<ContactBlock> blocks_;
};

}  // namespace pushback
