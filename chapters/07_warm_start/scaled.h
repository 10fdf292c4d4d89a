/// A warm start that is scaled down if it would be too large.
#pragma once

#include "pushback/chapters/07_warm_start/warm_start.h"

namespace pushback {

/// Replaces WarmStart. An impact is over in one step. If the next step started from its impulses, they would act a second time. The
/// sweeps minimise f, and a sweep over the normals never increases it:
///
///   f(lambda) = lambda . A lambda / 2 + lambda . (J V + b),   A = J M^-1 J^T
///
/// Along s lambda the slope of f at s = 0 is lambda . (J V + b). At s = 1 it is the same with the velocities after the guess. f is
/// the mean of both slopes. (Softness adds to A and to b.) If f > 0, the guess is worse than none. Then only the fraction s of it
/// is applied that makes the slope 0.
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
