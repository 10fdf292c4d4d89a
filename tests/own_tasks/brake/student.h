/// The brake of a wagon. The task is brake.md.
#pragma once

#include "asked.h"

namespace student {

using namespace pushback;

/// The impulse, N s, that a brake gives a wagon of `mass` kg during a step of `h` s. The wagon rolls at `speed` m/s, forwards or
/// backwards (negative). The brake's force is at most `strength` N.
inline Real brake(Real mass, Real speed, Real strength, Real h) {
  // TODO the impulse that stops the wagon, but no more than the brake can give in h
  (void)mass, (void)speed, (void)strength, (void)h;  // take this line out
  return 0;
  // TODO ends
}

inline const exercise_brake::Answer answer{brake};

}  // namespace student
