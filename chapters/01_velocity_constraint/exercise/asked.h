/// What exercise 01 asks for.
#pragma once

#include "pushback/common/exercise/exercise.h"
#include "pushback/common/world/world.h"

namespace pushback::exercise_01 {

struct Answer {
  std::function<void(World& world, int sweeps)> solve;  ///< changes the velocities of what touches
};

Numbers play(std::size_t check, Random& random, const Answer& answer);

}  // namespace pushback::exercise_01
