/// The answer to exercise 05, and its checks.
#pragma once

#include "pushback/chapters/01_velocity_constraint/any_effect.h"
#include "pushback/chapters/05_restitution/restitution.h"
#include "pushback/common/exercise/exercise.h"

namespace pushback::exercise_05 {

struct Answer {
  AnyEffect bounce;
};

std::vector<Check<Answer>> checks_of(const Answer& /*any*/);

}  // namespace pushback::exercise_05
