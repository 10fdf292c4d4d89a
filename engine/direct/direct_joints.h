/// All joints of a step solved at once, as one linear system.
#pragma once

#include "pushback/chapters/14_joints_under_load/warm_joints.h"
#include "pushback/engine/direct/joint_matrix.h"

namespace pushback {

/// Replaces Joints. In every sweep, all rows are one linear system for the present velocities:
///
///   A lambda = -(J V + b),   A = J M^-1 J^T + Gamma = L D L^T, in blocks, factored once per step
///
/// A row with limits is active while its impulse is between them. If the impulse would leave them, the row becomes inactive. It
/// then keeps the impulse of the limit, and the system is solved again without the row. If an inactive row's impulse would return,
/// the row becomes active again. This active-set method finds the one solution within all limits, mostly in two or three rounds.
/// The first guess of the active rows comes from the impulses of the previous step. Nothing else is stored, so the bias that beta
/// feeds back cannot build up.
///
/// Without contacts, one sweep is enough. With contacts, contacts and joints are solved in turn, and the last effect in the
/// solver's list is solved last.
struct DirectJoints : WarmJoints {
  int most_rounds = 50;  ///< of the active-set method in a sweep; then the rows with limits are swept once

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
  /// The matrix of this step. Rows that it does not solve are redundant, or keep the impulse of a limit.
  const JointMatrix& matrix() const { return matrix_; }

 private:
  bool guess_active_rows(StepContext& step);
  void solve_at_once();
  void find_wrong();

  JointMatrix matrix_;
  bool matrix_is_current_ = false;  // no body moves between the latest `factor` and the next substep
  std::vector<JointMatrix::JointBodies> joint_bodies_;
  std::vector<char> active_, active_before_;  // of each row
  std::vector<double> change_;
  std::vector<std::size_t> wrong_;  // rows
};

}  // namespace pushback
