/// The answer to exercise 04, and its checks.
#pragma once

#include "pushback/chapters/01_velocity_constraint/row.h"
#include "pushback/common/exercise/exercise.h"

namespace pushback::exercise_04 {

struct Answer {
  void (*set_bias)(Row& normal, Real beta, Real slop, Real h);
};

std::vector<Check<Answer>> checks_of(const Answer& /*any*/);

}  // namespace pushback::exercise_04
