/// What exercise 14 asks for.
#pragma once

#include "pushback/chapters/01_velocity_constraint/any_effect.h"
#include "pushback/chapters/14_joints_under_load/warm_joints.h"
#include "pushback/common/exercise/exercise.h"

namespace pushback::exercise_14 {

struct Answer {
  AnyEffect joints;
};

Numbers play(std::size_t check, Random& random, const Answer& answer);

}  // namespace pushback::exercise_14
