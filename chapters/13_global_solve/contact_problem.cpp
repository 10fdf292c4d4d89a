#include "chapters/13_global_solve/contact_problem.h"

#include <cmath>

namespace pushback {

using Eigen::Index;

Eigen::Vector3d projected_to_cone(const Eigen::Vector3d& r, double mu) {
  const double tangential = std::hypot(r[1], r[2]);
  if (tangential <= mu * r[0]) return r;
  if (mu * tangential <= -r[0]) return Eigen::Vector3d::Zero();
  const double normal = (r[0] + mu * tangential) / (1 + mu * mu);
  return {normal, mu * normal * r[1] / tangential, mu * normal * r[2] / tangential};
}

double relative_residual(const ContactProblem& problem, const Vector& r) {
  const Vector u = problem.speeds(r);
  double squared = 0;
  for (Index c = 0; c < problem.contacts(); ++c) {
    const double mu = problem.mu[c];
    Eigen::Vector3d s = u.segment<3>(3 * c);
    s[0] += mu * std::hypot(s[1], s[2]);
    const Eigen::Vector3d at = r.segment<3>(3 * c);
    squared += (at - projected_to_cone(at - s, mu)).squaredNorm();
  }
  const double unit = problem.q.norm();
  return std::sqrt(squared) / (unit > 0 ? unit : 1);
}

std::vector<Eigen::Matrix3d> diagonal_blocks(const ContactProblem& problem) {
  std::vector<Eigen::Matrix3d> blocks(static_cast<std::size_t>(problem.contacts()), Eigen::Matrix3d::Zero());
  for (Index row = 0; row < problem.w.rows(); ++row)
    for (SparseRows::InnerIterator it(problem.w, row); it; ++it)
      if (it.col() / 3 == row / 3) blocks[static_cast<std::size_t>(row / 3)](row % 3, it.col() % 3) = it.value();
  return blocks;
}

double asymmetry(const ContactProblem& problem) {
  const SparseRows transposed = problem.w.transpose();
  const SparseRows difference = problem.w - transposed;
  double largest = 0, apart = 0;
  for (Index row = 0; row < problem.w.rows(); ++row) {
    for (SparseRows::InnerIterator it(problem.w, row); it; ++it) largest = std::max(largest, std::abs(it.value()));
    for (SparseRows::InnerIterator it(difference, row); it; ++it) apart = std::max(apart, std::abs(it.value()));
  }
  return largest > 0 ? apart / largest : 0;
}

}  // namespace pushback
