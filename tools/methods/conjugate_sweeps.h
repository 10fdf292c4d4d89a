/// Conjugate gradients over sweeps (NNCG), with bodies.
#pragma once

#include "pushback/chapters/01_velocity_constraint/solver.h"

namespace pushback {

/// The last effect of a solver. A sweep takes the impulses r of all contacts to F(r); r - F(r) is used as a gradient g:
///
///   r <- F(r) + B p,   p <- B p - g,   B = |g|^2 / |g before|^2;   where B > 1 it starts afresh, p <- -g
///
/// as chapter 16's ConjugateSweeper does with a matrix; here the velocities follow r. The step ends with F(r), since r + B p need not
/// be within its cones.
///   M. Silcowitz, S. Niebe, K. Erleben, "A nonsmooth nonlinear conjugate gradient method for interactive contact force problems",
///   The Visual Computer 26, 2010
struct ConjugateSweeps : Effect {
  void start(StepContext& step) {
    at_.clear();
    for (const Row& row : step.rows) at_.push_back(row.impulse);
    way_.assign(at_.size(), 0);
    added_.assign(at_.size(), 0);
    last_squared_ = 0;
  }
  void sweep(StepContext& step) {
    Rows& rows = step.rows;
    Real squared = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) squared += (at_[i] - rows[i].impulse) * (at_[i] - rows[i].impulse);
    const Real ratio = last_squared_ > 0 ? squared / last_squared_ : 2;
    last_squared_ = squared;
    const Real goes_on = ratio > 1 ? 0 : ratio;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      added_[i] = goes_on * way_[i];
      way_[i] = added_[i] - (at_[i] - rows[i].impulse);
      add(rows[i], added_[i]);
      at_[i] = rows[i].impulse;
    }
  }
  /// Back to F(r).
  void finish(StepContext& step) {
    for (std::size_t i = 0; i < step.rows.size(); ++i) add(step.rows[i], -added_[i]);
  }

 private:
  static void add(Row& row, Real lambda) {
    if (lambda == 0) return;
    row.impulse += lambda;
    row.apply(lambda);
  }

  std::vector<Real> at_, way_, added_;  // N s, of each row: where this sweep began, p, and the latest B p
  Real last_squared_ = 0;               // |g|^2, (N s)^2
};

}  // namespace pushback
