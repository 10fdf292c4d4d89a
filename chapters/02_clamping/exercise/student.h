/// Exercise 02: accumulate, clamp, apply the difference. The task is chapters/02_clamping/exercise/task.md.
#pragma once

#include "pushback/chapters/02_clamping/exercise/asked.h"

namespace student {

using namespace pushback;

/// Solves the row of one contact as if no other existed. Called for each row in turn, over and over.
///
/// You read   row.speed()         J V, m/s: how fast the bodies separate now
///            row.bias            b, m/s
///            row.effective_mass  1 / K, kg
/// and keep   row.impulse         the sum of this row's impulses in this step, N s: 0 as the step begins
/// and call   row.apply(lambda)   V += M^-1 J^T lambda: changes the velocities of both bodies
inline void solve(Row& row) {
  // TODO the new sum, clamped (the equation of the page); then what of it has not been applied yet
  (void)row;  // take this line out
  // TODO ends
}

inline const exercise_02::Answer answer{solve};

}  // namespace student
