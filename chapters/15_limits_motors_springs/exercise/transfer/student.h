/// Exercise 15, transfer: a joint that breaks. The task is chapters/15_limits_motors_springs/exercise/transfer/task.md.
#pragma once

#include "pushback/chapters/15_limits_motors_springs/exercise/transfer/asked.h"

namespace student {

using namespace pushback;

/// The joints of chapter 13. All of them are rods of one row, which bear a force of at most `strength`.
///
/// You read    joint_rows_         the rows of this step: for (JointRow& row : joint_rows_), or joint_rows_[i]
///             step.dt             h, s
///             strength            F, N
/// of a row    impulse             the sum of its impulses in this step, N s: above 0 if the rod pushes, below 0 if it pulls
///             owner               the index of its joint in step.world.joints
/// and set     lo, hi              the least and the largest sum, N s, without limits if you do not set them
/// and change  step.world.joints   a std::vector<Joint>; the other joints keep their order
struct Breaking : Joints {
  Real strength = 100;  // N

  // TODO build: the limits of each row. report: a rod that has given all that it can is broken
  void build(StepContext& step) {
    Joints::build(step);  // makes the rows
  }
  void report(StepContext& step) {  // the end of the step, when the impulses are known
    (void)step;                     // take this line out
  }
  // TODO ends
};

inline const exercise_15_transfer::Answer answer{Breaking{}};

}  // namespace student
