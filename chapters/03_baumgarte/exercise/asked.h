/// The answer to exercise 03, and its checks.
#pragma once

#include "pushback/chapters/01_velocity_constraint/row.h"
#include "pushback/common/exercise/exercise.h"

namespace pushback::exercise_03 {

struct Answer {
  void (*push_out)(Row& normal, Real beta, Real cap, Real h);
};

std::vector<Check<Answer>> checks_of(const Answer& /*any*/);

}  // namespace pushback::exercise_03
