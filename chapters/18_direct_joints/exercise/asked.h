/// The answer to exercise 18, and its checks.
#pragma once

#include <Eigen/LU>

#include "pushback/common/exercise/exercise.h"

namespace pushback::exercise_18 {

using Blocks = std::vector<Eigen::Matrix3d>;
using Threes = std::vector<Eigen::Vector3d>;

struct Answer {
  Threes (*solve)(Blocks own, const Blocks& next, Threes wanted);
};

std::vector<Check<Answer>> checks_of(const Answer& /*any*/);

}  // namespace pushback::exercise_18
