/// Nonsmooth nonlinear conjugate gradients, which are sweeps that remember the direction in which impulses change.
///
/// A sweep maps r to F(r), and r is a solution if F(r) = r. The method uses r - F(r) as the gradient g, and applies the formula
/// of Fletcher and Reeves without a line search:
///
///   r <- F(r) + B p,   p <- B p - g,   B = |g|^2 / |g before|^2;   if B > 1 it restarts, p <- -g
///
/// M. Silcowitz, S. Niebe, K. Erleben, 2009 and 2010. They sweep with the friction pyramid. Here `TangentStep` is any step of
/// sweeps.h.
#pragma once

#include "pushback/engine/direct/sweeps.h"

namespace pushback {

template <class TangentStep>
class ConjugateSweeper {
 public:
  ConjugateSweeper(const ContactProblem& problem, const Vector& start)
      : sweeper_(problem), at_(start), way_(Vector::Zero(start.size())) {}

  /// Replaces r by F of the point that the last call extrapolated. The new r is inside its cones. The extrapolated point may be outside.
  void sweep(Vector& r) {
    r = at_;
    sweeper_.sweep(r);
    const Vector gradient = at_ - r;
    const double squared = gradient.squaredNorm(), ratio = last_squared_ > 0 ? squared / last_squared_ : 2;
    last_squared_ = squared;
    if (ratio > 1) {
      at_ = r;
      way_ = -gradient;
    } else {
      at_ = r + ratio * way_;
      way_ = ratio * way_ - gradient;
    }
  }

 private:
  Sweeper<TangentStep> sweeper_;
  Vector at_, way_;
  double last_squared_ = 0;  // of the gradient, (N s)^2
};

}  // namespace pushback
