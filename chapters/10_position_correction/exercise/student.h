/// Exercise 10: split impulse. The task is chapters/10_position_correction/exercise/task.md.
#pragma once

#include "pushback/chapters/10_position_correction/exercise/asked.h"

namespace student {

using namespace pushback;
using exercise_10::beta, exercise_10::rounds;

/// Called once the bodies have moved. Their velocities V are those that the step ends with.
///
/// You read   step.dt              h, s
///            step.world.bodies    each has `velocity` and `angular_velocity`
///            push.separation      C, m, before the bodies moved: negative where they overlap
///            push.speed()         J V, m/s, of the velocities that the bodies have at this moment
/// and set    push.bias            b', m/s
///            push.impulse         the sum of this push, N s: still what the step ended with
/// and call   push.solve()         one visit: accumulates, and clamps the sum, as in chapter 02
///            displace(body, shift, turn)   x += shift (m), and a turn (rad), both in world axes
inline void correct(CorrectingContext& step) {
  Rows pushes(step.rows.begin(), step.rows.begin() + std::ssize(step.contacts));  // the normals once more
  // TODO b' of each push; the velocities set aside; `rounds` rounds of solving; the bodies moved; the velocities put back
  (void)pushes;  // take this line out
  // TODO ends
}

inline const exercise_10::Answer answer{correct};

}  // namespace student
