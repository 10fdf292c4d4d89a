/// The answer to exercise 08, and its checks.
#pragma once

#include "pushback/chapters/01_velocity_constraint/row.h"
#include "pushback/common/exercise/exercise.h"

namespace pushback::exercise_08 {

struct Skate {
  Real k12;  ///< 1/kg, the change of the slip across the blade per impulse along it
  Real mu_along, mu_across;
  Real normal;  ///< the sum of the normal impulses, N s
};

struct Answer {
  void (*solve)(Row& along, Row& across, const Skate& skate);  ///< both tangents of a contact, once
};

std::vector<Check<Answer>> checks_of(const Answer& /*any*/);

}  // namespace pushback::exercise_08
