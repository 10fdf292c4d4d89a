#include "pushback/engine/direct/proximal_newton.h"

#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>

#include "pushback/engine/direct/coulomb_equation.h"

namespace pushback {

namespace {

using Eigen::Index;
using Eigen::Matrix3d;

/// A problem with the proximal term p (r - from).
class Proximal {
 public:
  explicit Proximal(const ContactProblem& problem) : problem_(problem) {
    for (const Matrix3d& block : diagonal_blocks(problem)) blocks_.emplace_back(block);
    fill_blocks();
    derivative_ = w_;
  }
  Vector from;
  double pull = 0;  ///< p, 1/kg

  ProximalStats stats;

  Vector f(const Vector& r) {
    stats.work += static_cast<double>(w_.nonZeros());
    Vector all(r.size());
    const Vector u = speeds(r);
    for (Index c = 0; c < problem_.contacts(); ++c) all.segment<3>(3 * c) = law(c, r, u).f;
    return all;
  }
  /// The Newton step. Not finite if f' is singular.
  Vector step(const Vector& r, const Vector& f_of_r) {
    const Vector u = speeds(r);
    for (Index c = 0; c < problem_.contacts(); ++c) {
      const CoulombEquation at = law(c, r, u);
      const Matrix3d own = at.df_dr + pull * at.df_du;
      const Index begin = derivative_.outerIndexPtr()[3 * c], count = derivative_.outerIndexPtr()[3 * c + 1] - begin;
      using ThreeRows = Eigen::Map<Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::RowMajor>>;
      using ThreeRowsOfW = Eigen::Map<const Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::RowMajor>>;
      ThreeRows(derivative_.valuePtr() + begin, 3, count) = at.df_du * ThreeRowsOfW(w_.valuePtr() + begin, 3, count);
      for (Index k = 0; k < count; ++k) {
        const Index column = derivative_.innerIndexPtr()[begin + k] - 3 * c;
        if (column >= 0 && column < 3)
          for (Index i = 0; i < 3; ++i) derivative_.valuePtr()[begin + i * count + k] += own(i, column);
      }
    }
    const Eigen::SparseMatrix<double> by_columns = derivative_;
    if (!analyzed_) lu_.analyzePattern(by_columns);
    analyzed_ = true;
    lu_.factorize(by_columns);
    ++stats.systems;
    stats.work += static_cast<double>(lu_.nnzL()) * static_cast<double>(lu_.nnzU()) / static_cast<double>(r.size());
    if (lu_.info() != Eigen::Success) return Vector::Constant(r.size(), std::nan(""));
    return lu_.solve(-f_of_r);
  }
  double largest_diagonal() const {
    double largest = 0;
    for (const ContactBlock& block : blocks_) largest = std::max(largest, block.w(0, 0));
    return largest;
  }

 private:
  /// W, with all nine of each 3 x 3 block that has any, so that three rows have the same columns.
  void fill_blocks() {
    const SparseMatrix& w = problem_.w;
    w_.resize(w.rows(), w.cols());
    std::vector<Index> blocks;
    for (Index first = 0; first < w.rows(); first += 3) {
      blocks.clear();
      for (Index row = first; row < first + 3; ++row)
        for (SparseMatrix::InnerIterator it(w, row); it; ++it)
          if (blocks.empty() || blocks.back() != it.col() / 3) blocks.push_back(it.col() / 3);
      std::sort(blocks.begin(), blocks.end());
      blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
      for (Index row = first; row < first + 3; ++row) {
        w_.startVec(row);
        SparseMatrix::InnerIterator it(w, row);
        for (const Index block : blocks) {
          for (Index column = 3 * block; column < 3 * block + 3; ++column) {
            const bool is_there = it && it.col() == column;
            w_.insertBack(row, column) = is_there ? it.value() : 0;
            if (is_there) ++it;
          }
        }
      }
    }
    w_.finalize();
  }
  Vector speeds(const Vector& r) const { return problem_.speeds(r) + pull * (r - from); }
  CoulombEquation law(Index c, const Vector& r, const Vector& u) const {
    return {blocks_[static_cast<std::size_t>(c)], problem_.mu[c], r.segment<3>(3 * c), u.segment<3>(3 * c)};
  }

  const ContactProblem& problem_;
  std::vector<ContactBlock> blocks_;
  SparseMatrix w_, derivative_;  // of the same pattern
  Eigen::SparseLU<Eigen::SparseMatrix<double>> lu_;
  bool analyzed_ = false;
};

/// Halves the step until |f| falls. Returns false if it does not.
bool shorten(Proximal& problem, const Vector& step, Vector& r, Vector& f) {
  if (!step.allFinite()) return false;
  const double before = f.norm();
  for (double part = 1; part > 1e-4; part /= 2) {
    const Vector tried = r + part * step, f_of_tried = problem.f(tried);
    if (f_of_tried.norm() >= (1 - 1e-4 * part) * before) continue;
    r = tried;
    f = f_of_tried;
    return true;
  }
  return false;
}

constexpr int most_steps = 40;
constexpr double rounding_of_f = 3e-16;  // of |r|: a smaller f is rounding

/// Newton steps until |f| is a thousandth of its initial value. Returns whether it is.
bool solve(Proximal& problem, Vector& r, int& steps, const ProximalLimits& limits) {
  Vector f = problem.f(r);
  const double enough = f.norm() / 1000;
  for (steps = 0; steps < most_steps; ++steps) {
    if (f.norm() <= std::max(enough, rounding_of_f * r.norm())) return true;
    if (problem.stats.work >= limits.work || !shorten(problem, problem.step(r, f), r, f)) return false;
  }
  return false;
}

}  // namespace

ProximalStats solve_proximal(const ContactProblem& problem, Vector& r, const ProximalLimits& limits) {
  double best = relative_residual(problem, r);
  if (best <= limits.tolerance) return {};
  Proximal pulled(problem);
  const double unit = pulled.largest_diagonal();
  if (unit <= 0) return {};
  Vector at = r, drift = Vector::Zero(r.size());
  pulled.pull = 1e-3 * unit;
  double last = best;
  int since_better = 0;
  for (int round = 0; round < limits.rounds && best > limits.tolerance && since_better < 100; ++round) {
    pulled.from = at + 2 * drift;  // along a valley the rounds take the same step over and over: look ahead
    Vector next = pulled.from;
    int steps = 0;
    const bool solved = solve(pulled, next, steps, limits);
    const double residual = relative_residual(problem, next);
    ++since_better;
    if (residual < best) {
      if (residual < 0.99 * best) since_better = 0;
      best = residual;
      r = next;
    }
    if (pulled.stats.work >= limits.work) break;
    const bool better = residual < 1.02 * last;
    drift = solved && better ? Vector(next - pulled.from) : Vector(Vector::Zero(r.size()));
    last = residual;
    if (solved) at = next;
    if (!solved) pulled.pull *= 10;
    else if (steps <= 6) pulled.pull /= 5;
    else if (steps > 20) pulled.pull *= 2;
  }
  return pulled.stats;
}

}  // namespace pushback
