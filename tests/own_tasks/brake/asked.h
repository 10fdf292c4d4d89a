/// What the exercise asks for.
#pragma once

#include "pushback/common/exercise/exercise.h"

namespace pushback::exercise_brake {

struct Answer {
  Real (*brake)(Real mass, Real speed, Real strength, Real h);
};

Numbers play(std::size_t check, Random& random, const Answer& answer);

}  // namespace pushback::exercise_brake
