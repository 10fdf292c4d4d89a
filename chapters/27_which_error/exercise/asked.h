/// The answer to exercise 27, and its checks.
#pragma once

#include "pushback/chapters/27_which_error/plain.h"
#include "pushback/common/exercise/exercise.h"

namespace pushback::exercise_27 {

using plain_27::Bar;
using plain_27::Played;

struct Answer {
  void (*play_step)(Played& played, Real h);
  Bar (*fooling_bar)();
};

std::vector<Check<Answer>> checks_of(const Answer& /*any*/);

}  // namespace pushback::exercise_27
