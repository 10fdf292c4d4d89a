/// All joints of a step solved at once, instead of one row after the other.
#pragma once

#include <Eigen/SparseCholesky>
#include <memory>

#include "pushback/chapters/13_joints/joints.h"
#include "pushback/chapters/16_whole_problem/matrix.h"

namespace pushback {

/// In the place of Joints. The rows without limits are one linear system, in every sweep for the velocities as they are then:
///
///   A lambda = -(J V + b),   A = J M^-1 J^T + gamma = L D L^T, sparse, made once a step
///
/// Without contacts and limits one sweep is all. With them, the two take turns; named last in the solver's list, joints have
/// the last word. Nothing is remembered, so what beta feeds back cannot build up. Rows with limits are swept as in Joints, and
/// all rows in a step in which A cannot be factored.
///
/// Joints may ask for the same thing twice, and A is singular then. 1 / D_i is the mass that row i feels while the rows before
/// it hold, 1 / A_ii what it feels alone. A row that feels 1 / least_pivot times as much gets no impulse: the others hold it.
struct DirectJoints : Joints {
  static constexpr Real least_pivot = Real(std::numeric_limits<Real>::digits > 24 ? 1e-8 : 3e-4);  ///< of D_i / A_ii

  void build(StepContext& step) {
    Joints::build(step);
    factor();
  }
  void sweep(StepContext&) {
    for (JointRow& row : joint_rows_)
      if (limited(row) || (at_once_.empty() && std::isfinite(row.effective_mass))) row.solve();
    solve_at_once();
  }
  void update_geometry(StepContext& step) {
    Joints::update_geometry(step);
    factor();
  }
  /// Indices in joint_rows() of the rows that are solved at once. Of those without limits, the missing ones are held by others.
  const std::vector<std::size_t>& rows_at_once() const { return at_once_; }

 private:
  static bool limited(const Row& row) { return std::isfinite(row.lo) || std::isfinite(row.hi); }
  void factor();
  void solve_at_once();

  std::vector<std::size_t> at_once_;
  std::shared_ptr<const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>> factors_;  // made anew, so copies may share
};

}  // namespace pushback
