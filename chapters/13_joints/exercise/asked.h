/// What exercise 13 asks for.
#pragma once

#include "pushback/common/exercise/exercise.h"
#include "pushback/common/world/world.h"

namespace pushback::exercise_13 {

struct Answer {
  std::function<Joint(const World& world, int a, int b, const Vec3& anchor, const Vec3& axis)> hinge;
};

Numbers play(std::size_t check, Random& random, const Answer& answer);

}  // namespace pushback::exercise_13
