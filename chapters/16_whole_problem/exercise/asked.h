/// What exercise 16 asks for.
#pragma once

#include "pushback/chapters/16_whole_problem/contact_problem.h"
#include "pushback/common/exercise/exercise.h"

namespace pushback::exercise_16 {

struct Answer {
  double (*residual)(const ContactProblem& problem, const Vector& r);
};

std::vector<Check<Answer>> checks_of(const Answer& /*any*/);

}  // namespace pushback::exercise_16
