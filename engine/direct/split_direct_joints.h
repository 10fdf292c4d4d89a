/// Joints solved at once, together with contacts, in a solver that relaxes (chapter 12).
#pragma once

#include "pushback/engine/direct/direct_joints.h"

namespace pushback {

/// Replaces SteadyJoints. Contacts and joints are solved in turn. If joints had the bias (beta / h) C in the sweeps, contacts
/// would react to the speed at which the bias closes the gaps of joints, and joints to that reaction. So the sweeps omit this
/// bias. After the last sweep, before the bodies move, the system is solved once more with the bias. After the bodies have moved,
/// the joints are solved again without the bias at the new positions. This removes the closing speed, except for the part that has
/// rotated with the bodies. That part compensates for the speed that their rotation loses, the fraction (w h)^2 / 2.
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
