/// Exercise 07: match two lists by id, rescale, project, apply. The task is chapters/07_warm_start/exercise/task.md.
#pragma once

#include "pushback/chapters/07_warm_start/exercise/asked.h"

namespace student {

using namespace pushback;

/// The step starts from the impulses of the step before.
///
/// You read   step.rows                    all rows, normals and tangents; of each row
///              row.owner                    the index of its contact in step.contacts
///              row.n                        its direction, unit, world axes
///            step.contacts[i].id          names the point: the same in two steps. Compare ids by ==
///            step.world.contacts_before   the contacts of the step before: a list of its own, each with
///              .id, .impulse                the impulse that it had as a vector in world axes, N s
///            step.dt, step.world.dt_before  s: the lengths of this step and of the one before
/// and call   row.reach(total)             brings Σλ of the row to `total` and applies to the bodies what is new of it
struct Remembering : Effect {
  void start(StepContext& step) {
    // TODO for each row: the old contact of the same id, if there is one; from its impulse, the row's first sum
    (void)step;  // take this line out
    // TODO ends
  }
};

inline const exercise_07::Answer answer{Remembering{}};

}  // namespace student
