/// A split impulse for joints: the part that closes gaps is kept apart from the part that carries, and not remembered.
#pragma once

#include "pushback/chapters/14_joints_under_load/warm_joints.h"

namespace pushback {

/// In the place of WarmJoints. With a warm start, lambda is a sum over the steps: each adds -(J V + b) / K. With (beta / h) C
/// in b the sum integrates C as well, and such a feedback may oscillate ever more. If the sweeps of a step leave the part rho
/// of an error, joints settle only while beta < (1 - rho) / rho.
///
/// So the sweeps solve J V + b = 0, and that is remembered. Only then are the rows swept as often again, with (beta / h) C:
///
///   z (z - rho) (z - 1) - rho^2 (z - 1)^2 + (1 - rho) beta z (z - rho) = 0       stable for every beta up to 1 (Jury)
///
/// Under an effect that relaxes (chapter 12) that push is taken back once the bodies have moved: it closes gaps, and adds no
/// speed.
struct SplitJoints : WarmJoints {
  int passes =
      1;  ///< over the rows, in each of the solver's sweeps: for long chains, where contacts need no more of them

  void check(StepContext& step) {
    if (passes < 1) throw InvalidInput(fmt::format("passes is {}: a whole number, 1 or more, is needed", passes));
    WarmJoints::check(step);
  }
  void build(StepContext& step) {
    WarmJoints::build(step);
    push_.clear();
    rounds_ = 0;
    for (JointRow& row : joint_rows_) {
      push_.push_back(row.softness == 0 ? beta / step.dt * row.separation : 0);
      row.bias -= push_.back();
    }
  }
  void sweep(StepContext& step) {
    for (int i = 0; i < passes; ++i, ++rounds_) WarmJoints::sweep(step);
  }
  void finish(StepContext& step) {
    remember(step);
    pushed_ = true;
    for (std::size_t i = 0; i < joint_rows_.size(); ++i) joint_rows_[i].bias += push_[i];
    for (int i = 0; i < rounds_; ++i) WarmJoints::sweep(step);
  }
  void report(StepContext& step) {
    Joints::report(step);
    if (!pushed_) remember(step);
    pushed_ = false;
  }
  void update_geometry(StepContext& step) {
    each_row(step, [](Row& row, const std::vector<Real>& impulses, std::size_t n) { row.reach(impulses[n]); });
    WarmJoints::update_geometry(step);
  }

 private:
  std::vector<Real> push_;  // (beta / h) C of each row, m/s
  int rounds_ = 0;          // over the rows, in this step
  bool pushed_ = false;     // since the last report
};

}  // namespace pushback
