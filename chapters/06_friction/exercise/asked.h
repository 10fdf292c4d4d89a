/// The answer to exercise 06, and its checks.
#pragma once

#include "pushback/chapters/01_velocity_constraint/row.h"
#include "pushback/common/exercise/exercise.h"

namespace pushback::exercise_06 {

/// Friction, rolling resistance and belts of a contact's two bodies A and B.
struct Surfaces {
  Real mu;                     ///< friction of the pair
  Real lever;                  ///< m; the torque of rolling resistance is at most this times the normal force
  Vec3 belt_a = Vec3::Zero();  ///< m/s, world axes, the velocity of A's surface relative to A, as of a conveyor belt
  Vec3 belt_b = Vec3::Zero();  ///< m/s, the same for B
};

struct Answer {
  void (*rub)(const Row& normal, Row& slip, Row& roll, const Surfaces& surfaces);
};

std::vector<Check<Answer>> checks_of(const Answer& /*any*/);

}  // namespace pushback::exercise_06
