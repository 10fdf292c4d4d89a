/// The answer to exercise 24, and its checks.
#pragma once

#include "pushback/chapters/24_half_step/plain.h"
#include "pushback/common/exercise/exercise.h"

namespace pushback::exercise_24 {

using plain_24::Bob;

struct Answer {
  void (*step)(Bob& bob, const Vec3& g, Real h);
};

std::vector<Check<Answer>> checks_of(const Answer& /*any*/);

}  // namespace pushback::exercise_24
