/// Exercise 08: a skate. The task is chapters/08_friction_cone/exercise/task.md.
#pragma once

#include "pushback/chapters/08_friction_cone/exercise/asked.h"

namespace student {

using namespace pushback;
using exercise_08::Skate;

/// Solves both tangents of a skate's contact, one along its blade and one across it. Called 300 times.
///
/// You read   along.speed(), across.speed()   u, the present slip of the skate in each direction, m/s
///            along.effective_mass            1 / k11, kg, and across.effective_mass is 1 / k22
///            skate.k12                       1/kg, which couples the two directions
///            skate.mu_along, mu_across       the coefficients of friction
///            skate.normal                    the sum of the normal impulses, N s
///            along.impulse, across.impulse   the sums of this step so far, N s
/// and call   along.reach(sum)                the sum becomes `sum`, and both bodies get the difference. across.reach likewise
inline void solve(Row& along, Row& across, const Skate& skate) {
  // TODO both sums, moved against the slip and projected, so that at the fixed point the law of the task holds
  (void)along, (void)across, (void)skate;  // take this line out
  // TODO ends
}

inline const exercise_08::Answer answer{solve};

}  // namespace student
