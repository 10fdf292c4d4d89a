/// The answer to the transfer exercise 15, and its checks.
#pragma once

#include "pushback/chapters/01_velocity_constraint/any_effect.h"
#include "pushback/chapters/13_joints/joints.h"
#include "pushback/common/exercise/exercise.h"

namespace pushback::exercise_15_transfer {

struct Answer {
  AnyEffect joints;
};

std::vector<Check<Answer>> checks_of(const Answer& /*any*/);

}  // namespace pushback::exercise_15_transfer
