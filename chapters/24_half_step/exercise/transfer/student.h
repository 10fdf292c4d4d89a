/// Exercise 24, transfer: an order without a truth. The task is chapters/24_half_step/exercise/transfer/task.md.
#pragma once

#include "pushback/chapters/24_half_step/exercise/transfer/asked.h"

namespace student {

using namespace pushback;
using exercise_24_transfer::Judged;

/// Judges a method whose error is c h^p, with c and p unknown.
///
/// You read   whole, half, quarter   its results with the steps h, h/2 and h/4; no two are equal
inline Judged judge(double whole, double half, double quarter) {
  Judged found;
  // TODO found.order: p; found.error: the error of quarter; found.better: the result for h = 0
  (void)whole, (void)half, (void)quarter;  // take this line out
  // TODO ends
  return found;
}

inline const exercise_24_transfer::Answer answer{judge};

}  // namespace student
