/// Exercise 12: soft contacts. The task is chapters/12_soft_contacts/exercise/task.md.
#pragma once

#include "pushback/chapters/12_soft_contacts/exercise/asked.h"

namespace student {

using namespace pushback;
using exercise_12::Spring;

/// Solves the row of one soft contact. Called in each sweep; and once more, with `relaxing`, when the bodies have moved.
///
/// You read   row.speed()           J V, m/s
///            row.separation        C, m: negative where the bodies overlap
///            row.effective_mass    1 / K, kg
///            row.impulse           the sum of this row's impulses in this step, N s; relaxing goes on from it
///            spring.hertz          its frequency; `pi` is a constant of this project
///            spring.zeta           its damping ratio
///            spring.h              of the step, s
/// and call   row.reach(sum)        the sum becomes `sum`, or 0 where `sum` is negative; the bodies get the difference
inline void solve(Row& row, const Spring& spring, bool relaxing) {
  // TODO b and gamma of the spring (the equation of the page), or of the relaxing pass; then one correction of the row
  (void)row, (void)spring, (void)relaxing;  // take this line out
  // TODO ends
}

inline const exercise_12::Answer answer{solve};

}  // namespace student
