/// The answer to exercise 00, and its checks.
#pragma once

#include "pushback/common/exercise/exercise.h"
#include "pushback/common/world/world.h"

namespace pushback::exercise_00 {

struct Answer {
  std::function<void(Body& bat, const Vec3& pivot, Body& ball, const Contact& contact)> hit;
};

std::vector<Check<Answer>> checks_of(const Answer& /*any*/);

}  // namespace pushback::exercise_00
