/// What exercise 03 asks for.
#pragma once

#include "pushback/chapters/01_velocity_constraint/row.h"
#include "pushback/common/exercise/exercise.h"

namespace pushback::exercise_03 {

struct Answer {
  void (*push_out)(Row& normal, Real beta, Real cap, Real h);
};

Numbers play(std::size_t check, Random& random, const Answer& answer);

}  // namespace pushback::exercise_03
