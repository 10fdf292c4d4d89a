/// Exercise 24, transfer: an order without a truth. The task is chapters/24_half_step/exercise/transfer/task.md.
#pragma once

#include "pushback/chapters/24_half_step/exercise/transfer/asked.h"

namespace student {

using namespace pushback;
using exercise_24_transfer::Judged;

/// Of a method whose error is c h^p, c and p unknown.
///
/// You read   whole, half, quarter   what it found with the steps h, h/2 and h/4; no two are equal
inline Judged judge(double whole, double half, double quarter) {
  Judged found;
  // TODO found.order: p; found.error: of quarter; found.better: what h = 0 would give
  (void)whole, (void)half, (void)quarter;  // take this line out
  // TODO ends
  return found;
}

inline const exercise_24_transfer::Answer answer{judge};

}  // namespace student
