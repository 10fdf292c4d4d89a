/// Friction that does not depend on the choice of tangents, because both impulses together stay within a disc.
#pragma once

#include "pushback/chapters/07_warm_start/warm_start.h"

namespace pushback {

/// The tangents' 2 x 2 block of J M^-1 J^T, 1/kg. It gives the change of the speeds along both tangents per impulse along each.
/// Symmetric, and positive definite if at least one of the bodies can move.
struct TangentBlock {
  Real k11, k12, k22;

  TangentBlock(const Row& one, const Row& two)
      : k11(1 / one.effective_mass),
        k12(two.n.dot(one.dvb - one.dva) + two.rb_n.dot(one.dwb) - two.ra_n.dot(one.dwa)),
        k22(1 / two.effective_mass) {}
  Real larger_eigenvalue() const { return (k11 + k22) / 2 + std::hypot((k11 - k22) / 2, k12); }
};

/// Replaces Friction.   |(sum(lambda_1), sum(lambda_2))| <= mu sum(lambda_n)
///
/// Both rows take a step of the same size. Sums outside the disc are projected to the nearest point of its edge:
///
///   (lambda_1, lambda_2) <- P_disc( (lambda_1, lambda_2) - (J_1 V, J_2 V) / k ),   k: the block's larger eigenvalue
///
/// At a fixed point of this iteration, friction opposes the slip exactly. With a different step size for each row, or with a step
/// that solves the block, the fixed point is a different one (scaled_back.h).
struct FrictionCone : Friction, UpdatesGeometry {
  void build(StepContext& step) {
    Friction::build(step);
    update_geometry(step);
  }
  /// A step larger than 1 / k can overshoot and add energy. So k is computed again whenever the rows have changed.
  void update_geometry(StepContext& step) {
    step_sizes_.clear();
    for (std::size_t i = 0; i < mu_.size(); ++i)
      step_sizes_.push_back(1 /
                            TangentBlock(step.rows[first_ + 2 * i], step.rows[first_ + 2 * i + 1]).larger_eigenvalue());
  }
  void sweep(StepContext& step) {
    Rows& rows = step.rows;
    for (std::size_t i = 0; i < mu_.size(); ++i) {
      Row &one = rows[first_ + 2 * i], &two = rows[first_ + 2 * i + 1];
      const Real total1 = one.impulse - step_sizes_[i] * one.speed();  // both read before either acts
      const Real total2 = two.impulse - step_sizes_[i] * two.speed();
      reach_in_disc(one, two, total1, total2, mu_[i] * rows[one.owner].impulse);
    }
    rows_solved += 2 * mu_.size();
  }
  void report(StepContext& step) {
    const Rows& rows = step.rows;
    for (std::size_t i = 0; i < mu_.size(); ++i) {
      const Row &one = rows[first_ + 2 * i], &two = rows[first_ + 2 * i + 1];
      const Real length = std::hypot(one.impulse, two.impulse);
      constexpr Real rounding = 16 * std::numeric_limits<Real>::epsilon();  // of a projection to the edge
      const bool held = length < (1 - rounding) * mu_[i] * rows[one.owner].impulse;
      step.contacts[one.owner].state = held ? ContactState::sticking : ContactState::sliding;
    }
  }

 protected:
  /// Changes the sums to (total1, total2), or to the nearest point of the disc. The root is computed only outside the disc, which is
  /// rare in a pile at rest. With std::hypot at every contact, ten sweeps would be a quarter slower.
  static void reach_in_disc(Row& one, Row& two, Real total1, Real total2, Real radius) {
    const Real squared = total1 * total1 + total2 * total2;
    if (squared > radius * radius) [[unlikely]] {
      const Real kept = radius / std::sqrt(squared);
      total1 *= kept;
      total2 *= kept;
    }
    one.reach(total1);
    two.reach(total2);
  }

 private:
  std::vector<Real> step_sizes_;  // 1 / k of each contact with friction, kg
};

}  // namespace pushback
