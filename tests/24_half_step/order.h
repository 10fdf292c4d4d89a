/// How tests of chapter 24 measure an order, and what a step conserves.
#pragma once

#include "pushback/chapters/19_accuracy_and_time/front.h"
#include "pushback/common/world/measure.h"
#include "pushback/engine/half_step/half_step.h"
#include "tests/support/joint_jacobian.h"
#include "tests/support/yardstick.h"

namespace pushback {

inline constexpr Real rounding = in_double ? Real(1e-11) : Real(1e-4);

/// Newton's method to rounding: what is left is the step's own error.
inline HalfStep exact(int substeps = 1, HalfStep step = {}) {
  step.substeps = substeps;
  if (in_double) step.tolerance = Real(1e-13);
  return step;
}

/// By how much the logarithm of an error falls for one of the substeps: the order.
template <class ErrorOf>
double order(const std::vector<int>& substeps, const ErrorOf& error_of) {
  std::vector<double> counts, errors;
  for (const int count : substeps) {
    counts.push_back(count);
    errors.push_back(static_cast<double>(error_of(count)));
  }
  return -study::slope(counts, errors);
}

inline Real energy(const World& world) {
  return kinetic_energy(world) + potential_energy(world);
}

/// Of all joints that hold rigidly: the largest |C|, m or rad, and the largest |J v|, m/s or rad/s.
struct Residuals {
  Real position = 0, velocity = 0;
};
inline Residuals residuals(const World& world) {
  Residuals largest;
  for (const Joint& joint : world.joints) {
    const Body &a = world.body(joint.a), &b = world.body(joint.b);
    for (const Equation& equation : asked_by(joint, a, b, {world.time, h})) {
      if (std::isfinite(equation.hi) || std::isfinite(equation.lo)) continue;
      largest.position = std::max(largest.position, std::abs(equation.error));
      largest.velocity = std::max(largest.velocity, std::abs(rate_of(equation, a, b)));
    }
  }
  return largest;
}
/// m, as detection would find it now.
inline Real deepest(World world) {
  world.find_contacts();
  return deepest_overlap(world);
}

}  // namespace pushback
