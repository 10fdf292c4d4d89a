/// The answer to exercise 21, and its checks.
#pragma once

#include "pushback/common/exercise/exercise.h"

namespace pushback::exercise_21 {

/// A contact as it was detected, once in a step.
struct Found {
  Vec3 n;             ///< unit, from A to B
  Vec3 arm_a, arm_b;  ///< m, from each centre of mass to the point
  Real C;             ///< C_0, m: negative where the bodies overlapped
};

/// The motion of a body since then, as sums over the substeps.
struct Moved {
  Vec3 way;   ///< of h v, m
  Vec3 turn;  ///< of h w, rad
};

struct Answer {
  Real (*separation)(const Found& found, const Moved& a, const Moved& b);  ///< C now, m
  Real (*bias)(Real C, Real rate, Real h);                                 ///< b of a substep, m/s
  Real (*relaxed_bias)(Real bias, Real C, Real h);                         ///< and of its relaxing pass, m/s
};

std::vector<Check<Answer>> checks_of(const Answer& /*any*/);

}  // namespace pushback::exercise_21
