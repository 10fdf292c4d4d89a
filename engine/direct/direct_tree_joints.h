/// Joints that form trees are solved at once; where they form loops, they are swept.
#pragma once

#include "pushback/chapters/14_joints_under_load/steady_joints.h"
#include "pushback/engine/direct/split_direct_joints.h"

namespace pushback {

/// In the place of SteadyJoints, under a solver that relaxes (chapter 12).
///
/// Rows of a loop may contradict each other: those of a cloth are more than its particles can follow. Solved exactly, such rows ask for
/// any speed; swept, each gives way a little. So joints are shared out: all that hang together, by bodies that move, are
/// solved by `trees` if there is one way from body to body, and by `loops` if there are two.
struct DirectTreeJoints : Effect, SupportsJoints, UpdatesGeometry {
  Real beta = Joints{}.beta;  ///< of both
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
  std::vector<bool> in_trees_, in_loops_;  // each joint
};

}  // namespace pushback
