/// What exercise 06 asks for.
#pragma once

#include "pushback/chapters/01_velocity_constraint/any_effect.h"
#include "pushback/common/exercise/exercise.h"

namespace pushback::exercise_06 {

struct Answer {
  AnyEffect friction;
};

Numbers play(std::size_t check, Random& random, const Answer& answer);

}  // namespace pushback::exercise_06
