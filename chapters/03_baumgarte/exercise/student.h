/// Exercise 03: a push-out with a cap on its speed. The task is chapters/03_baumgarte/exercise/task.md.
#pragma once

#include "pushback/chapters/03_baumgarte/exercise/asked.h"

namespace student {

using namespace pushback;

/// A step of h seconds should remove the fraction beta of the overlap, but the push-out is no faster than `cap`, m/s.
///
/// You read   normal.separation   C, m, negative if the bodies overlap, positive if they are still apart
/// and set    normal.bias         b, minus the target separating speed, m/s, which another effect may have set already
inline void push_out(Row& normal, Real beta, Real cap, Real h) {
  // TODO the bias of chapter 03, capped, but without a cap on the bias of another effect
  (void)normal, (void)beta, (void)cap, (void)h;  // take this line out
  // TODO ends
}

inline const exercise_03::Answer answer{push_out};

}  // namespace student
