/// Joints solved at once under a solver that relaxes (chapter 12), beside contacts.
#pragma once

#include "pushback/chapters/18_direct_joints/direct_joints.h"

namespace pushback {

/// In the place of SteadyJoints. Contacts and joints take turns, so contacts would answer a push that closes the gaps of
/// joints, and joints that answer. So the sweeps solve J V + b = 0; once they are done the system is solved once more with (beta / h) C,
/// which has the last word before the bodies move. Once they have moved that push is taken back (chapter 14), and the joints are
/// solved where they are now.
struct SplitDirectJoints : DirectJoints {
  void build(StepContext& step) {
    DirectJoints::build(step);
    for (JointRow& row : joint_rows_) row.bias -= push(row, step.dt);
  }
  void finish(StepContext& step) {
    remember(step);
    for (JointRow& row : joint_rows_) row.bias += push(row, step.dt);
    sweep(step);
  }
  void report(StepContext&) {}
  void update_geometry(StepContext& step) {
    DirectJoints::update_geometry(step);
  }

 private:
  Real push(const JointRow& row, Real h) const { return row.softness == 0 ? beta / h * row.separation : 0; }
};

}  // namespace pushback
