/// A row that may give way.
#pragma once

#include "pushback/chapters/01_velocity_constraint/row.h"

namespace pushback {

/// It wants J V + b + gamma lambda = 0: with gamma > 0 it is a spring with a damper, and gamma joins K.
struct JointRow : Row {
  Real softness;      // gamma, 1/kg or 1/(kg m^2); 0: it holds
  Real reported = 0;  // of `impulse`, what its joint has counted so far, N s

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
