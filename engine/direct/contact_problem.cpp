#include "pushback/engine/direct/contact_problem.h"

#include <cmath>

namespace pushback {

using Eigen::Index;

namespace {

/// || r - Pi(r - s) || / ||q||, each contact's r multiplied by scale(contact), its u and q divided by it.
template <class Scale>
double natural_map_error(const VectorView& r, const VectorView& u, const VectorView& q, const VectorView& mu,
                         const Scale& scale) {
  double squared = 0, unit = 0;
  for (Index c = 0; c < mu.size(); ++c) {
    Eigen::Vector3d s = u.segment<3>(3 * c) / scale(c);
    s[0] += mu[c] * std::hypot(s[1], s[2]);
    const Eigen::Vector3d at = r.segment<3>(3 * c) * scale(c);
    squared += (at - projected_to_cone(at - s, mu[c])).squaredNorm();
    unit += (q.segment<3>(3 * c) / scale(c)).squaredNorm();
  }
  return unit > 0 ? std::sqrt(squared) / std::sqrt(unit) : std::sqrt(squared);
}

}  // namespace

Eigen::Vector3d projected_to_cone(const Eigen::Vector3d& r, double mu) {
  const double tangential = std::hypot(r[1], r[2]);
  if (r[0] >= 0 && tangential <= mu * r[0]) return r;  // if mu = 0, only the first condition excludes a pull
  if (mu * tangential <= -r[0]) return Eigen::Vector3d::Zero();
  const double normal = (r[0] + mu * tangential) / (1 + mu * mu);
  return {normal, mu * normal * (r[1] / tangential), mu * normal * (r[2] / tangential)};
}

double relative_residual(const ContactProblem& problem, const Vector& r) {
  return relative_residual(r, problem.speeds(r), problem.q, problem.mu);
}

double relative_residual(const VectorView& r, const VectorView& u, const VectorView& q, const VectorView& mu) {
  return natural_map_error(r, u, q, mu, [](Index) { return 1.0; });
}

double unitless_residual(const ContactProblem& problem, const Vector& r) {
  const Vector scales = unit_scales(problem);
  return natural_map_error(r, problem.speeds(r), problem.q, problem.mu, [&](Index c) { return scales[c]; });
}

Vector unit_scales(const ContactProblem& problem) {
  Vector squared(problem.contacts());
  for (Index c = 0; const Eigen::Matrix3d& block : diagonal_blocks(problem)) squared[c++] = block.trace() / 3;
  const double largest = squared.size() > 0 ? squared.maxCoeff() : 0;
  for (double& d : squared)
    if (!(d > 0)) d = largest > 0 ? largest : 1;
  return squared.cwiseSqrt();
}

std::vector<Eigen::Matrix3d> diagonal_blocks(const ContactProblem& problem) {
  std::vector<Eigen::Matrix3d> blocks(static_cast<std::size_t>(problem.contacts()), Eigen::Matrix3d::Zero());
  for (Index row = 0; row < problem.w.rows(); ++row)
    for (SparseMatrix::InnerIterator it(problem.w, row); it; ++it)
      if (it.col() / 3 == row / 3) blocks[static_cast<std::size_t>(row / 3)](row % 3, it.col() % 3) = it.value();
  return blocks;
}

double asymmetry(const ContactProblem& problem) {
  const SparseMatrix transposed = problem.w.transpose();
  const SparseMatrix difference = problem.w - transposed;
  double largest = 0, apart = 0;
  for (Index row = 0; row < problem.w.rows(); ++row) {
    for (SparseMatrix::InnerIterator it(problem.w, row); it; ++it) largest = std::max(largest, std::abs(it.value()));
    for (SparseMatrix::InnerIterator it(difference, row); it; ++it) apart = std::max(apart, std::abs(it.value()));
  }
  return largest > 0 ? apart / largest : 0;
}

}  // namespace pushback
