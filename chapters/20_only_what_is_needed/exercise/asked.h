/// The answer to exercise 20, and its checks.
#pragma once

#include "pushback/common/exercise/exercise.h"
#include "pushback/common/world/world.h"

namespace pushback::exercise_20 {

struct Answer {
  std::vector<bool> (*asleep)(const World& world, const std::vector<bool>& rests);
};

std::vector<Check<Answer>> checks_of(const Answer& /*any*/);

}  // namespace pushback::exercise_20
