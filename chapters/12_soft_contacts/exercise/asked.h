/// What exercise 12 asks for.
#pragma once

#include "pushback/chapters/01_velocity_constraint/row.h"
#include "pushback/common/exercise/exercise.h"

namespace pushback::exercise_12 {

struct Spring {
  Real hertz;  ///< its frequency
  Real zeta;   ///< its damping ratio
  Real h;      ///< s, of the step
};

struct Answer {
  void (*solve)(Row& row, const Spring& spring, bool relaxing);  ///< the row of a soft contact, once
};

Numbers play(std::size_t check, Random& random, const Answer& answer);

}  // namespace pushback::exercise_12
