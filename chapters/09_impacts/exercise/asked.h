/// What exercise 09 asks for.
#pragma once

#include "pushback/chapters/01_velocity_constraint/solver.h"
#include "pushback/common/exercise/exercise.h"

namespace pushback::exercise_09 {

struct Answer {
  bool (*one_round)(StepContext& step, const std::vector<Real>& by_forces,
                    Real threshold);  ///< whether a pair has bounced
};

Numbers play(std::size_t check, Random& random, const Answer& answer);

}  // namespace pushback::exercise_09
