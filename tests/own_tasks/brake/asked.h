/// What the exercise asks for.
#pragma once

#include "pushback/common/exercise/exercise.h"

namespace pushback::exercise_brake {

struct Answer {
  Real (*brake)(Real mass, Real speed, Real strength, Real h);
};

std::vector<Check<Answer>> checks_of(const Answer& /*any*/);

}  // namespace pushback::exercise_brake
