/// Exercise 14: a split impulse for a chain. The task is chapters/14_joints_under_load/exercise/task.md.
#pragma once

#include "pushback/chapters/14_joints_under_load/exercise/asked.h"

namespace student {

using namespace pushback;

/// The joints of chapter 13 with a warm start, which remembers all of an impulse: also the push that closes a gap.
///
/// You read and set   joint_rows_             the rows of all joints: for (JointRow& row : joint_rows_)
/// of a row           bias                    b, m/s
///                    separation              C, m; `beta` is the part of it that a step takes away, step.dt is h, s
/// You read           rounds_                 how many sweeps over the joints this step has had so far
/// and call           WarmJoints::sweep(step)   one sweep more
///                    remember(step)            the next step starts from the impulses that the rows have now
struct Split : WarmJoints {
  // TODO build: take the push out of each b. finish, after the last sweep: the push, by as many sweeps once more.
  // When is the time to remember?
  void build(StepContext& step) {
    WarmJoints::build(step);  // makes the rows: b = ∂C/∂t + β/h C
  }
  void finish(StepContext& step) {
    (void)step;  // take this line out
  }
  void report(StepContext& step) {  // the end of the step
    remember(step);
  }
  // TODO ends

  void adjust_separation(StepContext&) { rounds_ = 0; }
  void sweep(StepContext& step) {
    WarmJoints::sweep(step);
    ++rounds_;
  }

 private:
  int rounds_ = 0;
};

inline const exercise_14::Answer answer{Split{}};

}  // namespace student
