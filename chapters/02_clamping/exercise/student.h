/// Exercise 02: a magnet that holds up to F. The task is chapters/02_clamping/exercise/task.md.
#pragma once

#include "pushback/chapters/02_clamping/exercise/asked.h"

namespace student {

using namespace pushback;

/// One sweep over the rows of a magnet, which are the normals of all points at which it touches. It is called repeatedly.
///
/// `force` is F, the most force with which the whole magnet holds, N. Each of its points holds an equal part. `h` is the length of
/// the step, s.
///
/// You read   rows.size()         the number of points; for (Row& row : rows) visits all
/// of a row   speed()             J V, the present separating speed, m/s
///            bias                b, m/s
///            effective_mass      1 / K, kg
/// and keep   impulse             the sum of this row's impulses in this step, N s, 0 at its beginning
/// and call   apply(lambda)       V += M^-1 J^T lambda, which changes the velocities of both bodies
inline void sweep(Rows& rows, Real force, Real h) {
  // TODO for each row the new sum within its allowed interval, then the difference that has not been applied yet
  (void)rows, (void)force, (void)h;  // take this line out
  // TODO ends
}

inline const exercise_02::Answer answer{sweep};

}  // namespace student
