/// A near miss for comparison, which solves both tangents at once and then scales the impulse back.
#pragma once

#include "pushback/chapters/08_friction_cone/friction_cone.h"

namespace pushback {

/// It looks better than a step of 1/k, because without the disc both speeds would be exactly 0.
///
///   (lambda_1, lambda_2) <- P_disc( (lambda_1, lambda_2) - K_t^-1 (J_1 V, J_2 V) ),   K_t: the tangents' 2 x 2 block
///
/// At its fixed point a sliding contact has friction opposite to K_t^-1 u, not to the slip u.
struct FrictionScaledBack : FrictionCone {
  void build(StepContext& step) {
    Friction::build(step);
    const Rows& rows = step.rows;
    blocks_.clear();
    for (std::size_t i = 0; i < mu_.size(); ++i) blocks_.emplace_back(rows[first_ + 2 * i], rows[first_ + 2 * i + 1]);
  }
  void sweep(StepContext& step) {
    Rows& rows = step.rows;
    for (std::size_t i = 0; i < mu_.size(); ++i) {
      Row &one = rows[first_ + 2 * i], &two = rows[first_ + 2 * i + 1];
      const TangentBlock& k = blocks_[i];
      const Real u1 = one.speed(), u2 = two.speed(), determinant = k.k11 * k.k22 - k.k12 * k.k12;
      const Real total1 = one.impulse - (k.k22 * u1 - k.k12 * u2) / determinant;
      const Real total2 = two.impulse - (k.k11 * u2 - k.k12 * u1) / determinant;
      reach_in_disc(one, two, total1, total2, mu_[i] * rows[one.owner].impulse);
    }
    rows_solved += 2 * mu_.size();
  }

 private:
  std::vector<TangentBlock> blocks_;
};

}  // namespace pushback
