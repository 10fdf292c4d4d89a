/// Nonsmooth nonlinear conjugate gradients: sweeps that remember where they were going.
///
/// A sweep takes r to F(r); solved means F(r) = r. Take r - F(r) for the gradient g of something that falls, and go on as
/// Fletcher and Reeves would, without any search along the line:
///
///   r <- F(r) + B p,   p <- B p - g,   B = |g|^2 / |g before|^2;   where B > 1 it starts afresh, p <- -g
///
/// M. Silcowitz, S. Niebe, K. Erleben, 2009 and 2010. Theirs sweeps the pyramid; here it is any of the three.
#pragma once

#include "pushback/engine/direct/sweeps.h"

namespace pushback {

template <class TangentStep>
class ConjugateSweeper {
 public:
  ConjugateSweeper(const ContactProblem& problem, const Vector& start)
      : sweeper_(problem), at_(start), way_(Vector::Zero(start.size())) {}

  /// r becomes F of where the last step led: within its cones, which r + B p need not be.
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
