/// What exercise 20 asks for.
#pragma once

#include "pushback/common/exercise/exercise.h"
#include "pushback/common/world/world.h"

namespace pushback::exercise_20 {

struct Answer {
  std::vector<bool> (*asleep)(const World& world, const std::vector<bool>& rests);
};

Numbers play(std::size_t check, Random& random, const Answer& answer);

}  // namespace pushback::exercise_20
