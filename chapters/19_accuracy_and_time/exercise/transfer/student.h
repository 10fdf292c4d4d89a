/// Exercise 19, transfer: a truth of one's own. The task is chapters/19_accuracy_and_time/exercise/transfer/task.md.
#pragma once

#include "pushback/chapters/19_accuracy_and_time/exercise/transfer/asked.h"

namespace student {

using namespace pushback;
using exercise_19_transfer::g;  // 9.81 m/s^2

/// Returns the distance of a box from its start after t seconds, m, up the slope. Negative if the box is below its start.
///
/// You read   speed   m/s, up the slope, at the start; 0 or more
///            slope   rad, between the slope and the horizontal; above 0
///            mu      the coefficient of friction, 0 or more
///            t       s, 0 or more
inline double way(double speed, double slope, double mu, double t) {
  // TODO the closed form: up until the box stops, and then friction holds it there, or it slides back
  (void)speed, (void)slope, (void)mu, (void)t;  // take this line out
  return 0;
  // TODO ends
}

inline const exercise_19_transfer::Answer answer{way};

}  // namespace student
