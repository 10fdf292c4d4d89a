/// What exercise 06 asks for.
#pragma once

#include "pushback/chapters/01_velocity_constraint/row.h"
#include "pushback/common/exercise/exercise.h"

namespace pushback::exercise_06 {

/// How the surfaces of a contact's two bodies A and B rub and roll on each other.
struct Surfaces {
  Real mu;                     ///< friction of the pair
  Real lever;                  ///< m: rolling resistance holds a turn with up to this times the normal force
  Vec3 belt_a = Vec3::Zero();  ///< m/s, world axes: how A's surface runs over A, as the belt of a conveyor does
  Vec3 belt_b = Vec3::Zero();  ///< m/s: the same for B
};

struct Answer {
  void (*rub)(const Row& normal, Row& slip, Row& roll, const Surfaces& surfaces);
};

std::vector<Check<Answer>> checks_of(const Answer& /*any*/);

}  // namespace pushback::exercise_06
