/// The answer to exercise 01, and its checks.
#pragma once

#include "pushback/chapters/01_velocity_constraint/row.h"
#include "pushback/common/exercise/exercise.h"

namespace pushback::exercise_01 {

struct Answer {
  std::function<void(Body& body, const Vec3& ring, const Vec3& rail, const Vec3& rails_velocity, int sweeps)> hold;
};

std::vector<Check<Answer>> checks_of(const Answer& /*any*/);

}  // namespace pushback::exercise_01
