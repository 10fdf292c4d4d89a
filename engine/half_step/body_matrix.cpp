#include "pushback/engine/half_step/body_matrix.h"

#include <Eigen/LU>
#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <algorithm>

namespace pushback {

bool BodyMatrix::begin(int bodies, const Pairs& pairs, double most) {
  const bool known = order_.size() == static_cast<std::size_t>(bodies) && pairs == pairs_;
  if (!known || (!whole_ && of_factor_ <= most)) analyse(bodies, pairs, most);
  if (of_factor_ > most) return false;
  for (Column& column : columns_) column.diagonal.setIdentity();
  for (Entry& entry : entries_) {
    entry.lower.setZero();
    entry.upper.setZero();
  }
  return true;
}

void BodyMatrix::analyse(int bodies, const Pairs& pairs, double most) {
  pairs_ = pairs;
  whole_ = false;
  std::vector<Eigen::Triplet<double>> pattern;
  for (int body = 0; body < bodies; ++body) pattern.emplace_back(body, body, 1);
  for (const auto& [one, other] : pairs) {
    pattern.emplace_back(one, other, 1);
    pattern.emplace_back(other, one, 1);
  }
  Eigen::SparseMatrix<double> shared(bodies, bodies);
  shared.setFromTriplets(pattern.begin(), pattern.end());
  Eigen::AMDOrdering<int>::PermutationType permutation;
  Eigen::AMDOrdering<int>()(shared, permutation);
  order_.assign(permutation.indices().data(), permutation.indices().data() + bodies);
  position_.resize(order_.size());
  for (std::size_t k = 0; k < order_.size(); ++k) position_[static_cast<std::size_t>(order_[k])] = static_cast<int>(k);

  // Those whose blocks the elimination of a body changes: its later neighbours, and what earlier ones have handed on.
  std::vector<std::vector<int>> later(order_.size());
  for (const auto& [one, other] : pairs)
    if (earlier(one, other)) later[static_cast<std::size_t>(one)].push_back(other);
    else later[static_cast<std::size_t>(other)].push_back(one);
  of_factor_ = 0;
  for (const int body : order_) {
    auto& own = later[static_cast<std::size_t>(body)];
    std::sort(own.begin(), own.end(), [this](int one, int other) { return earlier(one, other); });
    own.erase(std::unique(own.begin(), own.end()), own.end());
    const auto blocks = static_cast<double>(own.size());
    of_factor_ += 216 * (1 + 2 * blocks + blocks * (blocks - 1));
    if (of_factor_ > most) return;  // before any block exists: blocks take far more time and memory
    if (own.empty()) continue;
    auto& next = later[static_cast<std::size_t>(own.front())];
    next.insert(next.end(), own.begin() + 1, own.end());
  }
  whole_ = true;
  columns_.resize(order_.size());
  entries_.clear();
  for (std::size_t body = 0; body < later.size(); ++body) {
    columns_[body].begin = entries_.size();
    for (const int other : later[body]) entries_.push_back({.later = other});
    columns_[body].end = entries_.size();
  }
  updates_.clear();
  for (std::size_t body = 0; body < later.size(); ++body) {
    columns_[body].updates = updates_.size();
    for (auto p = later[body].begin(); p != later[body].end(); ++p)
      for (auto q = p + 1; q != later[body].end(); ++q)
        updates_.push_back(static_cast<std::size_t>(&entry_of(*p, *q) - entries_.data()));
  }
}

BodyMatrix::Entry& BodyMatrix::entry_of(int one, int other) {
  if (!earlier(one, other)) std::swap(one, other);
  const Column& column = column_of(one);
  return *std::lower_bound(entries_.begin() + std::ptrdiff_t(column.begin),
                           entries_.begin() + std::ptrdiff_t(column.end), other,
                           [this](const Entry& entry, int body) { return earlier(entry.later, body); });
}

void BodyMatrix::add(int row, int column, const Block& block) {
  if (row == column) column_of(row).diagonal += block;
  else if (earlier(row, column)) entry_of(row, column).upper += block;
  else entry_of(row, column).lower += block;
}

bool BodyMatrix::factor() {
  for (const int body : order_) {
    Column& column = column_of(body);
    column.diagonal = column.diagonal.inverse().eval();
    if (!column.diagonal.allFinite()) return false;
    const std::size_t* changed = updates_.data() + column.updates;
    for (std::size_t p = column.begin; p < column.end; ++p) entries_[p].lower *= column.diagonal;
    for (std::size_t p = column.begin; p < column.end; ++p) {
      const Entry& one = entries_[p];
      column_of(one.later).diagonal.noalias() -= one.lower * one.upper;
      for (std::size_t q = p + 1; q < column.end; ++q) {
        const Entry& other = entries_[q];
        Entry& between = entries_[*changed++];
        between.upper.noalias() -= one.lower * other.upper;
        between.lower.noalias() -= other.lower * one.upper;
      }
    }
  }
  return true;
}

void BodyMatrix::solve(std::vector<Six>& x) const {
  for (const int body : order_) {
    const Column& column = column_of(body);
    const Six& own = x[static_cast<std::size_t>(body)];
    for (std::size_t at = column.begin; at < column.end; ++at)
      x[static_cast<std::size_t>(entries_[at].later)].noalias() -= entries_[at].lower * own;
  }
  for (auto body = order_.rbegin(); body != order_.rend(); ++body) {
    const Column& column = column_of(*body);
    Six own = x[static_cast<std::size_t>(*body)];
    for (std::size_t at = column.begin; at < column.end; ++at)
      own.noalias() -= entries_[at].upper * x[static_cast<std::size_t>(entries_[at].later)];
    x[static_cast<std::size_t>(*body)].noalias() = column.diagonal * own;
  }
}

}  // namespace pushback
