/// Exercise 09: sequential impacts. The task is chapters/09_impacts/exercise/task.md.
#pragma once

#include "pushback/chapters/09_impacts/exercise/asked.h"

namespace student {

using namespace pushback;

/// One round of sequential impacts, before the first sweep: visits each contact once, in the order of the list. Gives back
/// whether a pair has bounced. If so, it is called again.
///
/// You read   step.contacts.size()            how many contacts there are; step.rows[i] is the normal row of step.contacts[i]
///            step.contacts[i].restitution    e of this pair
///            by_forces[i]                    m/s: what this step's forces have added to J V of row i
/// of a row   speed()                         J V, m/s: how fast the bodies separate now, with what the forces have added
///            effective_mass                  1 / K, kg
///            impulse                         the sum of this row's impulses in this step, N s
/// and call   reach(sum)                      brings the row's sum to `sum`: the bodies feel the difference
/// and set    lo                              the least that later sweeps may lower the sum to, N s; 0 at first
inline bool one_round(StepContext& step, const std::vector<Real>& by_forces, Real threshold) {
  // TODO the impulse of the page for each pair that approaches faster than the threshold; the sweeps must not take
  // it back
  (void)step, (void)by_forces, (void)threshold;  // take these two lines out
  return false;
  // TODO ends
}

inline const exercise_09::Answer answer{one_round};

}  // namespace student
