/// What exercise 07 asks for.
#pragma once

#include "pushback/chapters/01_velocity_constraint/any_effect.h"
#include "pushback/common/exercise/exercise.h"

namespace pushback::exercise_07 {

struct Answer {
  AnyEffect warm_start;
};

Numbers play(std::size_t check, Random& random, const Answer& answer);

}  // namespace pushback::exercise_07
