/// What exercise 03 asks for.
#pragma once

#include "pushback/chapters/01_velocity_constraint/any_effect.h"
#include "pushback/common/exercise/exercise.h"

namespace pushback::exercise_03 {

struct Answer {
  AnyEffect push_out;
};

Numbers play(std::size_t check, Random& random, const Answer& answer);

}  // namespace pushback::exercise_03
