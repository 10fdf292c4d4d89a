/// Exercise 03: the push-out. The task is chapters/03_baumgarte/exercise/task.md.
#pragma once

#include "pushback/chapters/03_baumgarte/exercise/asked.h"

namespace student {

using namespace pushback;

/// The part beta of the overlap should be gone after one step.
///
/// You read    step.contacts.size()  how many contacts there are; the rows of their normals are step.rows[0], [1], ...
///             step.dt               h, s
/// of a row    separation            C, m: negative where the bodies overlap, positive where they are still apart
/// and set     bias                  b, m/s: minus the separating speed that is wanted; another effect may have set it
struct PushOut : Effect {
  Real beta = Real(0.2);

  void build(StepContext& step) {
    // TODO the bias of each row by Baumgarte stabilization; of two wishes, the one for more speed stays
    (void)step;  // take this line out
    // TODO ends
  }
};

inline const exercise_03::Answer answer{PushOut{}};

}  // namespace student
