/// Joints solved at once under a solver that relaxes (chapter 12), beside contacts.
#pragma once

#include "pushback/engine/direct/direct_joints.h"

namespace pushback {

/// In the place of SteadyJoints. Contacts and joints take turns, so contacts would answer a push that closes the gaps of
/// joints, and joints that answer. So the sweeps solve J V + b = 0; once they are done the system is solved once more with (beta / h) C,
/// which has the last word before the bodies move. Once they have moved, the joints are solved where they are now. That takes
/// the push back but for the part that has turned with the bodies, which makes up for what their turn costs: (w h)^2 / 2 of the speed.
struct SplitDirectJoints : DirectJoints {
  void build(StepContext& step) {
    DirectJoints::build(step);
    for (JointRow& row : joint_rows_) row.bias -= push(row, step.dt);
  }
  void finish(StepContext& step) {
    for (JointRow& row : joint_rows_) row.bias += push(row, step.dt);
    sweep(step);
  }

 private:
  Real push(const JointRow& row, Real h) const { return row.softness == 0 ? beta / h * row.separation : 0; }
};

}  // namespace pushback
