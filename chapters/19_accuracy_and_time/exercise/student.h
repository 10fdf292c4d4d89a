/// Exercise 19: the front of a diagram. The task is chapters/19_accuracy_and_time/exercise/task.md.
#pragma once

#include "pushback/chapters/19_accuracy_and_time/exercise/asked.h"

namespace student {

using namespace pushback;
using study::Measured, study::Measurements;

/// Returns the settings that no other setting beats, from the fastest to the most accurate.
///
/// You read   one.median()   s, the median over all rounds in which the setting was timed
///            one.error      m, its error, infinite if the motion was lost
/// You may sort `all`, for example with std::sort, or loop over it as it is.
inline Measurements front(Measurements all) {
  Measurements found;
  // TODO the Pareto front: one setting beats another if it is at least as good in time and in error, and better in one
  (void)all;  // take this line out
  // TODO ends
  return found;
}

inline const exercise_19::Answer answer{front};

}  // namespace student
