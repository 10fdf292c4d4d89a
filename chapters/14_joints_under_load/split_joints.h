/// A split impulse for joints. The impulse that closes gaps is separate from the impulse that carries loads, and is not stored.
#pragma once

#include "pushback/chapters/14_joints_under_load/warm_joints.h"

namespace pushback {

/// Replaces WarmJoints. With a warm start, lambda is a sum over the steps: each step adds -(J V + b) / K. With (beta / h) C in
/// b the sum integrates C as well, and such feedback can oscillate with growing amplitude. If the sweeps of a step leave a
/// fraction rho of an error, joints settle only if beta < (1 - rho) / rho.
///
/// Therefore the sweeps solve J V + b = 0, and only this impulse is stored. The same number of sweeps follows with (beta / h) C:
///
///   z (z - rho) (z - 1) - rho^2 (z - 1)^2 + (1 - rho) beta z (z - rho) = 0       stable for every beta up to 1 (Jury)
///
/// With an effect that relaxes (chapter 12), the push is taken back once the bodies have moved, so it closes gaps but adds no
/// speed.
struct SplitJoints : WarmJoints {
  int passes = 1;  ///< over the rows in each sweep: more for long chains, without more sweeps of the contacts

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
  int rounds_ = 0;          // passes over the rows in this step
  bool pushed_ = false;     // `finish` has run since the last report
};

}  // namespace pushback
