/// A warm start scaled down where all of it would be too much.
#pragma once

#include "pushback/chapters/07_warm_start/warm_start.h"

namespace pushback {

/// Replaces WarmStart. An impact is over in one step. If the next step started from its impulses, it would strike again. The
/// sweeps minimise f, and no sweep over the normals raises it:
///
///   f(lambda) = lambda . A lambda / 2 + lambda . (J V + b),   A = J M^-1 J^T
///
/// Along s lambda its slope is lambda . (J V + b) at s = 0, and at s = 1 the same with the velocities that the guess leaves;
/// f is the mean of both. (Softness adds to A and to b.) If f > 0, the guess is worse than none. Then only a fraction s of it
/// is applied, where s makes the slope 0.
struct ScaledWarmStart : WarmStart {
  void start(auto& step) {
    Rows& rows = step.rows;
    error_.clear();
    for (std::size_t i = 0; i < rows.size(); ++i) error_.push_back(step.speed_error(i));
    WarmStart::start(step);
    Real slope_before = 0, slope_after = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      slope_before += rows[i].impulse * error_[i];
      slope_after += rows[i].impulse * step.speed_error(i);
    }
    if (slope_before + slope_after <= 0) return;
    const Real scale = slope_before < 0 ? slope_before / (slope_before - slope_after) : 0;
    for (Row& row : rows) row.reach(scale * row.impulse);
  }

 private:
  std::vector<Real> error_;  // J V + b before the guess, m/s
};

}  // namespace pushback
