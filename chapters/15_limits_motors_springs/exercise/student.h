/// Exercise 15: a rope that can only pull. The task is chapters/15_limits_motors_springs/exercise/task.md.
#pragma once

#include "pushback/chapters/15_limits_motors_springs/exercise/asked.h"

namespace student {

using namespace pushback;

/// Called at the start of a step of h seconds. A hand holds the rope with at most `strength`, N. Under more it slips.
///
/// You read   rope.separation   C = L - |P_B - P_A|, m. It is positive if the rope is slack, negative if it is too long
/// and set    rope.bias         b, m/s, of J V + b = 0; J V is the rate at which C grows
///            rope.lo, rope.hi  the least and the largest sum of its impulses in this step, N s. An impulse above 0 pulls
inline void pull(JointRow& rope, Real strength, Real beta, Real h) {
  // TODO the limits of the sum, and b of a limit that is not reached, and of one that is passed (the table of the page)
  (void)rope, (void)strength, (void)beta, (void)h;  // take this line out
  // TODO ends
}

inline const exercise_15::Answer answer{pull};

}  // namespace student
