/// The answer to the transfer exercise 19, and its checks.
#pragma once

#include "pushback/common/exercise/exercise.h"

namespace pushback::exercise_19_transfer {

inline constexpr double g = 9.81;  ///< m/s^2

struct Answer {
  double (*way)(double speed, double slope, double mu, double t);
};

std::vector<Check<Answer>> checks_of(const Answer& /*any*/);

}  // namespace pushback::exercise_19_transfer
