#include "pushback/chapters/18_direct_joints/direct_joints.h"

#include <cmath>

namespace pushback {

namespace {

using Eigen::Index;
using Symmetric = Eigen::SparseMatrix<double>;
using Places = std::vector<std::size_t>;

Symmetric matrix_of(const JointRows& rows, const Places& places) {
  Rows chosen;
  std::vector<Real> softness;
  for (const std::size_t place : places) {
    chosen.push_back(rows[place]);
    softness.push_back(rows[place].softness);
  }
  return pushback::matrix_of(chosen, softness);
}

/// Of the rows at `places`, those that ask for something that the ones before them do not hold already.
Places independent(const JointRows& rows, const Places& places) {
  Symmetric a = matrix_of(rows, places);
  const Vector diagonal = a.diagonal();
  // No pivot may be 0, or rounding would be divided by rounding. What is added is far below the pivots that are kept.
  const double little = std::pow(static_cast<double>(DirectJoints::least_pivot), 1.5);
  for (Index i = 0; i < a.rows(); ++i) a.coeffRef(i, i) *= 1 + little;
  const Eigen::SimplicialLDLT<Symmetric> factors(a);
  Places kept;
  if (factors.info() != Eigen::Success) return kept;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto row = static_cast<Index>(i);
    const Index permuted = factors.permutationP().indices()[row];
    if (factors.vectorD()[permuted] > static_cast<double>(DirectJoints::least_pivot) * diagonal[row])
      kept.push_back(places[i]);
  }
  return kept;
}

}  // namespace

void DirectJoints::factor() {
  at_once_.clear();
  for (std::size_t i = 0; i < joint_rows_.size(); ++i)
    if (!limited(joint_rows_[i]) && std::isfinite(joint_rows_[i].effective_mass)) at_once_.push_back(i);
  at_once_ = independent(joint_rows_, at_once_);
  if (at_once_.empty()) return;
  factors_ = std::make_shared<const Eigen::SimplicialLDLT<Symmetric>>(matrix_of(joint_rows_, at_once_));
  if (factors_->info() != Eigen::Success) at_once_.clear();  // D was left unfinished: not to be read
}

void DirectJoints::solve_at_once() {
  if (at_once_.empty()) return;
  Vector error(static_cast<Index>(at_once_.size()));
  for (std::size_t i = 0; i < at_once_.size(); ++i) {
    error[static_cast<Index>(i)] = static_cast<double>(joint_rows_[at_once_[i]].speed_error());
  }
  const Vector change = factors_->solve(-error);
  for (std::size_t i = 0; i < at_once_.size(); ++i) {
    JointRow& row = joint_rows_[at_once_[i]];
    row.reach(row.impulse + static_cast<Real>(change[static_cast<Index>(i)]));
  }
}

}  // namespace pushback
