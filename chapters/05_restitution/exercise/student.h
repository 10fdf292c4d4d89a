/// Exercise 05: a restitution that falls with the speed. The task is chapters/05_restitution/exercise/task.md.
#pragma once

#include "pushback/chapters/05_restitution/exercise/asked.h"

namespace student {

using namespace pushback;

/// A bounce of bodies that yield in hard impacts. Up to the yield speed, e is the contact's own value, and above it e falls.
///
/// You read   step.contacts.size()                the number of contacts, where step.rows[i] is the row of step.contacts[i]
///            approach_speed(step.world, contact)  v_n before the step, m/s, negative while the bodies approach
/// of a contact   restitution                     e of slow impacts, 0 to 1
/// and set        step.rows[i].bias               b, minus the target separating speed, m/s, which the push-out may have set
struct YieldingBounce : Effect {
  Real threshold = Real(0.1);  // m/s; slower impacts do not bounce
  Real yield = 2;              // m/s

  void build(StepContext& step) {
    // TODO for each normal row: first the e of this impact, by the law of the task, then the bias as in chapter 05
    (void)step;  // take this line out
    // TODO ends
  }
};

inline const exercise_05::Answer answer{YieldingBounce{}};

}  // namespace student
