/// How tests of chapter 24 measure an order, and what a step conserves.
#pragma once

#include "pushback/chapters/19_accuracy_and_time/front.h"
#include "pushback/common/world/measure.h"
#include "pushback/engine/half_step/half_step.h"
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

}  // namespace pushback
