/// What exercise 08 asks for.
#pragma once

#include "pushback/chapters/01_velocity_constraint/row.h"
#include "pushback/common/exercise/exercise.h"

namespace pushback::exercise_08 {

struct Answer {
  void (*solve)(Row& one, Row& two, Real k12, Real bound);  ///< both tangents of a contact, once
};

Numbers play(std::size_t check, Random& random, const Answer& answer);

}  // namespace pushback::exercise_08
