/// Exercise 17: one pivot. The task is chapters/17_direct_contacts/exercise/task.md.
#pragma once

#include "pushback/chapters/17_direct_contacts/exercise/asked.h"

namespace student {

using namespace pushback;
using Eigen::Index;

/// Lets the variable `entering` grow until the first basic variable reaches 0, which then leaves. Returns the variable that has
/// left. If none ever reaches 0, changes nothing and returns -1.
///
/// You read and change   tableau.t(i, j)      the equations, where t.row(i) is one of them
///                       tableau.basis[i]     the basic variable of row i
/// and read              t(i, last)           its value, 0 or more
///                       t(i, entering)       the amount by which it falls if `entering` grows by 1
inline Index pivot(exercise_17::Tableau& tableau, Index entering) {
  Eigen::MatrixXd& t = tableau.t;
  const Index last = t.cols() - 1;
  // TODO the ratio test finds the row that is first to reach 0. Solve this row for `entering`, and substitute it into the others
  (void)entering, (void)last;  // take this line out
  return -1;
  // TODO ends
}

inline const exercise_17::Answer answer{pivot};

}  // namespace student
