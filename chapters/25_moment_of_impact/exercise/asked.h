/// The answer to exercise 25, and its checks.
#pragma once

#include "pushback/chapters/25_moment_of_impact/plain.h"
#include "pushback/common/exercise/exercise.h"

namespace pushback::exercise_25 {

using plain_25::Ball;

struct Answer {
  void (*step)(Ball& ball, Real g, Real h);
};

std::vector<Check<Answer>> checks_of(const Answer& /*any*/);

}  // namespace pushback::exercise_25
