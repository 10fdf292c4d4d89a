/// The answer to exercise 15, and its checks.
#pragma once

#include "pushback/chapters/13_joints/joint_row.h"
#include "pushback/common/exercise/exercise.h"

namespace pushback::exercise_15 {

struct Answer {
  void (*pull)(JointRow& rope, Real strength, Real beta, Real h);
};

std::vector<Check<Answer>> checks_of(const Answer& /*any*/);

}  // namespace pushback::exercise_15
