/// What exercise 00 asks for.
#pragma once

#include "pushback/common/exercise/exercise.h"
#include "pushback/common/world/world.h"

namespace pushback::exercise_00 {

struct Answer {
  std::function<void(World& world, Contact& contact)> impact;  ///< changes the velocities of its two bodies
};

Numbers play(std::size_t check, Random& random, const Answer& answer);

}  // namespace pushback::exercise_00
