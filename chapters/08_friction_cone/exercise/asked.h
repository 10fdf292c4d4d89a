/// What exercise 08 asks for.
#pragma once

#include "pushback/chapters/01_velocity_constraint/row.h"
#include "pushback/common/exercise/exercise.h"

namespace pushback::exercise_08 {

struct Skate {
  Real k12;  ///< 1/kg: what an impulse along the blade adds to the slip across it
  Real mu_along, mu_across;
  Real normal;  ///< the sum of the normal impulses, N s
};

struct Answer {
  void (*solve)(Row& along, Row& across, const Skate& skate);  ///< both tangents of a contact, once
};

std::vector<Check<Answer>> checks_of(const Answer& /*any*/);

}  // namespace pushback::exercise_08
