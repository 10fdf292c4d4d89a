#include "pushback/chapters/17_direct_contacts/pivoting.h"

#include <Eigen/QR>
#include <cmath>
#include <vector>

namespace pushback {

using Eigen::Index;

namespace {

/// The equation w - A l - z = b, solved for the variables in the basis. Columns: w_0.., l_0.., z, and the right-hand side.
class Tableau {
 public:
  Tableau(const Eigen::MatrixXd& a, const Vector& b) : rows_(b.size()), t_(b.size(), 2 * b.size() + 2) {
    t_ << Eigen::MatrixXd::Identity(rows_, rows_), -a, -Vector::Ones(rows_), b;
    for (Index i = 0; i < rows_; ++i) basis_.push_back(i);
  }
  Index z() const { return 2 * rows_; }
  Index basic(Index row) const { return basis_[static_cast<std::size_t>(row)]; }
  double value(Index row) const { return t_(row, 2 * rows_ + 1); }
  static Index partner(Index variable, Index rows) { return variable < rows ? variable + rows : variable - rows; }

  void pivot(Index row, Index entering) {
    t_.row(row) /= t_(row, entering);
    for (Index i = 0; i < rows_; ++i)
      if (i != row && t_(i, entering) != 0) t_.row(i) -= t_(i, entering) * t_.row(row).eval();
    basis_[static_cast<std::size_t>(row)] = entering;
  }
  /// The row whose variable is the first to reach 0 as `entering` grows; -1 if none does.
  Index leaving(Index entering) const {
    Index best = -1;
    for (Index i = 0; i < rows_; ++i)
      if (t_(i, entering) > least_pivot && (best < 0 || before(i, best, entering))) best = i;
    return best;
  }
  /// The row where b is least.
  Index lowest() const {
    Index row = 0;
    t_.col(2 * rows_ + 1).minCoeff(&row);
    return row;
  }

 private:
  static constexpr double least_pivot = 1e-9;

  bool before(Index i, Index j, Index entering) const {
    return value(i) / t_(i, entering) < value(j) / t_(j, entering);
  }

  Index rows_;
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> t_;
  std::vector<Index> basis_;
};

/// Relaxes each row by a different small amount, so that no two reach 0 together. A problem that has a solution keeps one.
Vector untied(const Vector& b) {
  constexpr double golden = 0.6180339887498949;
  Vector loosened = b;
  for (Index i = 0; i < b.size(); ++i) {
    const double step = static_cast<double>(i + 1) * golden;
    loosened[i] += 1e-7 * (1 + step - std::floor(step));
  }
  return loosened;
}

/// Makes the pressing rows hold exactly, by the least change of their impulses.
void sharpen(const Eigen::MatrixXd& a, const Vector& b, Vector& impulses) {
  std::vector<Index> pressing;
  for (Index i = 0; i < b.size(); ++i)
    if (impulses[i] > 0) pressing.push_back(i);
  if (pressing.empty()) return;
  const Vector speeds = a * impulses + b;
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition;
  decomposition.setThreshold(1e-10);  // three contacts determine a face
  decomposition.compute(a(pressing, pressing));
  impulses(pressing) -= decomposition.solve(speeds(pressing)).eval();
  impulses = impulses.cwiseMax(0);
}

}  // namespace

std::optional<Pivoted> solve_by_pivoting(const SparseMatrix& a, const Vector& b) {
  Pivoted result{Vector::Zero(b.size()), 0};
  if (b.size() == 0 || b.minCoeff() >= 0) return result;
  double of_a = 0;  // A and b are scaled to about 1, so that the same values count as 0 in all problems
  for (Index i = 0; i < b.size(); ++i) of_a = std::max(of_a, a.coeff(i, i));
  const double of_b = b.cwiseAbs().maxCoeff();
  if (of_a <= 0) return {};
  const Eigen::MatrixXd scaled_a = Eigen::MatrixXd(a) / of_a;
  const Vector scaled_b = b / of_b;
  Tableau tableau(scaled_a, untied(scaled_b));
  Index row = tableau.lowest(), entering = tableau.z();
  while (true) {
    const Index left = tableau.basic(row);
    tableau.pivot(row, entering);
    ++result.pivots;
    if (left == tableau.z()) break;
    if (result.pivots > 100 * b.size()) return {};
    entering = Tableau::partner(left, b.size());
    row = tableau.leaving(entering);
    if (row < 0) return {};  // a ray: no l exists, because A is semi-definite
  }
  for (Index i = 0; i < b.size(); ++i)
    if (const Index variable = tableau.basic(i); variable >= b.size() && variable < 2 * b.size())
      result.impulses[variable - b.size()] = std::max(0.0, tableau.value(i));
  sharpen(scaled_a, scaled_b, result.impulses);
  result.impulses *= of_b / of_a;
  return result;
}

double complementarity_error(const SparseMatrix& a, const Vector& b, const Vector& impulses) {
  return impulses.cwiseMin(a * impulses + b).cwiseAbs().maxCoeff();
}

}  // namespace pushback
