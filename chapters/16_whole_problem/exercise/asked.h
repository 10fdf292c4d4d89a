/// The answer to exercise 16, and its checks.
#pragma once

#include "pushback/common/exercise/exercise.h"
#include "pushback/engine/direct/contact_problem.h"

namespace pushback::exercise_16 {

struct Answer {
  double (*residual)(const ContactProblem& problem, const Vector& r);
};

std::vector<Check<Answer>> checks_of(const Answer& /*any*/);

}  // namespace pushback::exercise_16
