/// The answer to exercise 19, and its checks.
#pragma once

#include "pushback/chapters/19_accuracy_and_time/front.h"
#include "pushback/common/exercise/exercise.h"

namespace pushback::exercise_19 {

struct Answer {
  study::Measurements (*front)(study::Measurements all);
};

std::vector<Check<Answer>> checks_of(const Answer& /*any*/);

}  // namespace pushback::exercise_19
