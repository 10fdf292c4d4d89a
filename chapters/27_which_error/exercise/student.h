/// Exercise 27: two estimates, and a scene that fools one of them. The task is chapters/27_which_error/exercise/task.md.
#pragma once

#include "pushback/chapters/27_which_error/exercise/asked.h"

namespace student {

using namespace pushback;
using exercise_27::Bar;
using exercise_27::Played;
using plain_27::coarse, plain_27::fine, plain_27::step;

/// `play_step` takes a step of h seconds and updates both estimates.
///
/// You read    step(bar, h, n)   the bar after h seconds, in n substeps
///             fine, coarse      the numbers of substeps of the bar and of its twin
/// You change  played.bar        the bar after the step
///             played.halves     m, plus the difference of the same step in fine / 2 substeps, in y and in half a second of v
///             played.twin       its twin after the step
///
/// `fooling_bar` returns a bar {y, v, angle, spin} (m, m/s, rad, rad/s).

// TODO both functions, in place of these
inline void play_step(Played& played, Real h) {
  (void)played, (void)h;
}
inline Bar fooling_bar() {
  return {1, 0, 0, 0};
}
// TODO ends

inline const exercise_27::Answer answer{play_step, fooling_bar};

}  // namespace student
