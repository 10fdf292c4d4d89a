/// All joints of a step solved at once, instead of one row after the other.
#pragma once

#include "pushback/chapters/14_joints_under_load/warm_joints.h"
#include "pushback/engine/direct/joint_matrix.h"

namespace pushback {

/// In the place of Joints. All rows are one linear system, in every sweep for the velocities as they are then:
///
///   A lambda = -(J V + b),   A = J M^-1 J^T + Gamma = L D L^T, in blocks, made once a step
///
/// A row with limits takes part while its impulse is between them. Where it would leave them it is held at the limit, where it
/// would come back it takes part again, and the system is solved anew without it or with it: the one solution that keeps all
/// limits (an active set), mostly in two or three rounds. What acted in the step before is the first guess, and all that is remembered, so
/// what beta feeds back cannot build up.
///
/// Without contacts one sweep is all. With them, the two take turns; named last in the solver's list, joints have the last word.
struct DirectJoints : WarmJoints {
  int most_rounds = 50;  ///< of guesses which limits act, in a sweep; after them the rows with limits are swept once

  void check(StepContext& step) {
    if (most_rounds < 1)
      throw InvalidInput(fmt::format("most_rounds is {}: a whole number, 1 or more, is needed", most_rounds));
    WarmJoints::check(step);
    matrix_is_current_ = false;
  }
  void build(StepContext& step) {
    WarmJoints::build(step);
    if (guess_active_rows(step) || !matrix_is_current_) matrix_.factor(joint_rows_, joint_bodies_, active_);
  }
  void start(StepContext& step);
  void sweep(StepContext&);
  void update_geometry(StepContext& step) {
    WarmJoints::update_geometry(step);
    matrix_.factor(joint_rows_, joint_bodies_, active_);
    matrix_is_current_ = true;
  }
  /// Of this step: which rows are solved at once. Of those that are not, others hold what some ask for, and limits hold the rest.
  const JointMatrix& matrix() const { return matrix_; }

 private:
  bool guess_active_rows(StepContext& step);
  void solve_at_once();
  void find_wrong();

  JointMatrix matrix_;
  bool matrix_is_current_ = false;  // the bodies, in the substep that comes next
  std::vector<JointMatrix::JointBodies> joint_bodies_;
  std::vector<char> active_, active_before_;  // of each row
  std::vector<double> change_;
  std::vector<std::size_t> wrong_;  // rows
};

}  // namespace pushback
