/// What the transfer exercise 19 asks for.
#pragma once

#include "pushback/common/exercise/exercise.h"

namespace pushback::exercise_19_transfer {

inline constexpr double g = 9.81;  ///< m/s^2

struct Answer {
  double (*way)(double speed, double slope, double mu, double t);
};

Numbers play(std::size_t check, Random& random, const Answer& answer);

}  // namespace pushback::exercise_19_transfer
