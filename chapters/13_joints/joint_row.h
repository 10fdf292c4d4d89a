/// A row that can be soft.
#pragma once

#include "pushback/chapters/01_velocity_constraint/row.h"

namespace pushback {

/// Solves J V + b + gamma lambda = 0. With gamma > 0 the row is a spring with a damper, and gamma is added to K.
struct JointRow : Row {
  Real softness;      // gamma, 1/kg or 1/(kg m^2); 0: rigid
  Real reported = 0;  // the amount of `impulse` that its joint has counted so far, N s

  JointRow(Body& first, Body& second, const Jacobian& jacobian, std::size_t joint, Real gamma)
      : Row(first, second, jacobian, joint), softness(gamma) {
    effective_mass /= 1 + gamma * effective_mass;  // 1 / (K + gamma)
  }
  /// J V + b + gamma lambda, m/s.
  Real speed_error() const { return speed() + bias + softness * impulse; }
  Real wanted() const { return impulse - effective_mass * (speed() + (bias + softness * impulse)); }
  void solve() { reach(wanted()); }
  Real error() const { return std::abs(std::clamp(wanted(), lo, hi) - impulse) / effective_mass; }
};

using JointRows = std::vector<JointRow>;

}  // namespace pushback
