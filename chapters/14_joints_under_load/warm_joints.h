/// A warm start for joints, as chapter 07 has for contacts.
#pragma once

#include "pushback/chapters/13_joints/joints.h"

namespace pushback {

/// Replaces Joints. A joint has the same number of equations in every step, so row n starts from impulse n of the step before.
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
  /// Calls `use(row, impulses, n)` for each row. impulses: last_impulses of its joint, N s. n: the row's index within its joint.
  template <class Use>
  void each_row(StepContext& step, const Use& use) {
    Joints::each_row([&](JointRow& row, std::size_t n) { use(row, step.world.joints[row.owner].last_impulses, n); });
  }
};

}  // namespace pushback
