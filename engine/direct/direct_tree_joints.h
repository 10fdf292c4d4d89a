/// Solves joints that form trees at once, and sweeps joints that form loops.
#pragma once

#include "pushback/chapters/14_joints_under_load/steady_joints.h"
#include "pushback/engine/direct/split_direct_joints.h"

namespace pushback {

/// Replaces SteadyJoints in a solver that relaxes (chapter 12).
///
/// The rows of a loop may contradict each other, because a cloth, for example, has more rows than its particles have degrees of
/// freedom. An exact solution of such rows has arbitrarily large speeds, but sweeps leave a small error in each row. So each group
/// of joints that moving bodies connect goes to `trees` if there is a single path from each body to each other, and otherwise to
/// `loops`.
struct DirectTreeJoints : Effect, SupportsJoints, UpdatesGeometry {
  Real beta = Joints{}.beta;  ///< of the joints in trees and in loops
  SplitDirectJoints trees;
  SteadyJoints loops;

  void check(StepContext& step) {
    assign_joints(step.world);
    trees.beta = loops.beta = beta;
    trees.only(in_trees_);
    loops.only(in_loops_);
    each([&](auto& some) { some.check(step); });
  }
  void build(StepContext& step) {
    each([&](auto& some) { some.build(step); });
  }
  void start(StepContext& step) {
    each([&](auto& some) { some.start(step); });
  }
  void sweep(StepContext& step) {
    each([&](auto& some) { some.sweep(step); });
  }
  void finish(StepContext& step) {
    each([&](auto& some) { some.finish(step); });
  }
  void report(StepContext& step) {
    each([&](auto& some) { some.report(step); });
  }
  void update_geometry(StepContext& step) {
    each([&](auto& some) { some.update_geometry(step); });
  }
  JointRows joint_rows() const {
    JointRows all = trees.joint_rows();
    all.insert(all.end(), loops.joint_rows().begin(), loops.joint_rows().end());
    return all;
  }

 private:
  template <class Act>
  void each(const Act& act) {
    act(trees);
    act(loops);
  }
  void assign_joints(const World& world);

  std::vector<JoinedBodies> bodies_;       // of each joint
  std::vector<bool> in_trees_, in_loops_;  // whether each joint is in a tree, and in a loop
};

}  // namespace pushback
