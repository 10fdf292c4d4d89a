/// Exercise 08: the tangents' step that is exact at its fixed point. The task is chapters/08_friction_cone/exercise/task.md.
#pragma once

#include "pushback/chapters/08_friction_cone/exercise/asked.h"

namespace student {

using namespace pushback;

/// Solves both tangents of one contact. Called in each sweep, after the normal.
///
/// You read   one.speed(), two.speed()   u, m/s: how fast the point slips along each tangent now
///            one.effective_mass         1 / k11, kg; and two.effective_mass 1 / k22
///            k12                        1/kg: what an impulse of 1 N s along one tangent adds to the slip along the other
///            bound                      mu times the sum of the normal impulses, N s: the radius of the disc
///            one.impulse, two.impulse   the sums of this step so far, N s
/// and call   one.reach(sum)             the sum becomes `sum`, and both bodies get the difference; and two.reach
inline void solve(Row& one, Row& two, Real k12, Real bound) {
  // TODO the block's larger eigenvalue; both sums, moved against the slip; their projection to the disc
  (void)one, (void)two, (void)k12, (void)bound;  // take this line out
  // TODO ends
}

inline const exercise_08::Answer answer{solve};

}  // namespace student
