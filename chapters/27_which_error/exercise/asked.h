/// The answer to exercise 27, and its checks.
#pragma once

#include "pushback/chapters/27_which_error/plain.h"
#include "pushback/common/exercise/exercise.h"

namespace pushback::exercise_27 {

using plain_27::Bounds;
using plain_27::Tried;
using plain_27::Verdict;

struct Answer {
  Real (*off_by)(Real coarse, Real fine, int order);
  Verdict (*judge)(const Tried& tried, const Bounds& bounds);
};

std::vector<Check<Answer>> checks_of(const Answer& /*any*/);

}  // namespace pushback::exercise_27
