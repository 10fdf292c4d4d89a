/// The answer to the transfer exercise 24, and its checks.
#pragma once

#include "pushback/common/exercise/exercise.h"

namespace pushback::exercise_24_transfer {

struct Judged {
  double order = 0;   ///< p
  double error = 0;   ///< of the best of the three, 0 or more
  double better = 0;  ///< a result without that error
};

struct Answer {
  Judged (*judge)(double whole, double half, double quarter);
};

std::vector<Check<Answer>> checks_of(const Answer& /*any*/);

}  // namespace pushback::exercise_24_transfer
