/// Joints that start from where the last step ended, as contacts do in chapter 07.
#pragma once

#include "pushback/chapters/13_joints/joints.h"

namespace pushback {

/// In the place of Joints. A joint has as many equations in every step, so the n-th is the same one as in the step before.
struct WarmJoints : Joints {
  void start(StepContext& step) {
    const Real scale = step.world.impulse_scale(step.dt);
    each_row(step, [scale](Row& row, std::vector<Real>& impulses, std::size_t n) {
      if (n < impulses.size()) row.reach(scale * impulses[n]);
    });
  }
  void report(StepContext& step) {
    Joints::report(step);
    remember(step);
  }

 protected:
  void remember(StepContext& step) {
    each_row(step, [](const Row& row, std::vector<Real>& impulses, std::size_t n) {
      impulses.resize(n);
      impulses.push_back(row.impulse);
    });
  }
  /// `use(row, impulses, n)`: the n-th of its joint, from 0; and what the joint keeps, N s.
  template <class Use>
  void each_row(StepContext& step, const Use& use) {
    Joints::each_row([&](JointRow& row, std::size_t n) { use(row, step.world.joints[row.owner].last_impulses, n); });
  }
};

}  // namespace pushback
