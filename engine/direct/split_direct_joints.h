/// Joints solved at once, together with contacts, in a solver that relaxes (chapter 12).
#pragma once

#include "pushback/engine/direct/direct_joints.h"

namespace pushback {

/// Replaces SteadyJoints. Contacts and joints are solved in turn. If joints had the bias (beta / h) C in the sweeps, contacts
/// would react to the speed with which it closes the gaps of joints, and joints to that reaction. So the sweeps leave this bias
/// out. After the last sweep, before the bodies move, the system is solved once more with it. After the bodies have moved, the
/// joints are solved again at the new positions without it, which removes the closing speed, except for the part that has
/// turned with the bodies. That part compensates the loss that their turn causes, (w h)^2 / 2 of the speed.
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
