/// Exercise 11: the loop of substeps. The task is chapters/11_substeps/exercise/task.md.
#pragma once

#include "pushback/chapters/11_substeps/exercise/asked.h"

namespace student {

using namespace pushback;
using exercise_11::Parts;

/// Simulates `dt` seconds as `count` substeps of equal length.
///
/// You are told  before                       s: how long the latest substep before this call was
/// and call      parts.add_gravity(seconds)   v += seconds g
///               parts.detect()               the contacts as they are now; their impulses of the latest substep are kept
///               parts.solve(seconds, scale)  one sweep: b is beta / seconds (C + slop), and each row starts from its kept
///                                            impulse times `scale`
///               parts.move(seconds)          x += seconds v, and the turn
inline void frame(Parts& parts, Real dt, int count, Real before) {
  // TODO the loop: which parts belong into it, with which seconds, and with which scale?
  (void)parts, (void)dt, (void)count, (void)before;  // take this line out
  // TODO ends
}

inline const exercise_11::Answer answer{frame};

}  // namespace student
