#include "pushback/engine/direct/joint_matrix.h"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <algorithm>

namespace pushback {

namespace {

using JointBodies = JointMatrix::JointBodies;

std::vector<JoinedBodies> bodies_of(const std::vector<JointBodies>& joints) {
  std::vector<JoinedBodies> all;
  for (const JointBodies& joint : joints) all.push_back(std::minmax({joint.a, joint.b}));
  return all;
}

/// In a tree, from the leaves to the root. If there are loops, an order of approximate minimum degree.
std::vector<int> order_of_elimination(const std::vector<JoinedBodies>& joints) {
  const std::vector<bool> in = in_loops(joints);
  if (std::find(in.begin(), in.end(), true) == in.end()) {
    std::vector<int> order = root_first(joints);
    std::reverse(order.begin(), order.end());
    return order;
  }
  const int count = static_cast<int>(joints.size());
  std::vector<Eigen::Triplet<double>> entries;
  const auto neighbours = joint_neighbours(joints);
  for (int i = 0; i < count; ++i) {
    entries.emplace_back(i, i, 1);
    for (const int j : neighbours[static_cast<std::size_t>(i)]) entries.emplace_back(i, j, 1);
  }
  Eigen::SparseMatrix<double> pattern(count, count);
  pattern.setFromTriplets(entries.begin(), entries.end());
  Eigen::AMDOrdering<int>::PermutationType permutation;
  Eigen::AMDOrdering<int>()(pattern, permutation);
  return {permutation.indices().data(), permutation.indices().data() + count};
}

/// For each joint, its position in the order of elimination.
std::vector<int> positions_in(const std::vector<int>& order) {
  std::vector<int> position(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) position[static_cast<std::size_t>(order[k])] = static_cast<int>(k);
  return position;
}

/// For each joint, the joints that its elimination changes, which are its later neighbours, and the ones that earlier joints
/// have passed on to it.
std::vector<std::vector<int>> changed_by_elimination(const std::vector<JoinedBodies>& joints,
                                                     const std::vector<int>& order, const std::vector<int>& position) {
  const auto earlier = [&](int i, int j) {
    return position[static_cast<std::size_t>(i)] < position[static_cast<std::size_t>(j)];
  };
  const auto neighbours = joint_neighbours(joints);
  std::vector<std::vector<int>> changed(joints.size());
  for (const int joint : order) {
    auto& own = changed[static_cast<std::size_t>(joint)];
    for (const int other : neighbours[static_cast<std::size_t>(joint)])
      if (earlier(joint, other)) own.push_back(other);
    std::sort(own.begin(), own.end(), earlier);
    own.erase(std::unique(own.begin(), own.end()), own.end());
    if (own.empty()) continue;
    auto& next = changed[static_cast<std::size_t>(own.front())];
    next.insert(next.end(), own.begin() + 1, own.end());
  }
  return changed;
}

/// Calls `act(n)`. If n is 3, as for a ball and socket, it is a compile-time constant, so the loops of the most frequent joint
/// are unrolled.
template <class Act>
[[gnu::always_inline]] inline void with_number(int n, const Act& act) {
  if (n == 3) act(std::integral_constant<int, 3>{});
  else act(n);
}

/// J of one body. It is a copy, because the compiler would read the row again after each number that is written.
struct OfBody {
  Vec3 n, r_n;

  OfBody(const JointRow& row, bool is_b) : n(is_b ? row.n : Vec3(-row.n)), r_n(is_b ? row.rb_n : Vec3(-row.ra_n)) {}
  /// J_i (M^-1 J_j^T)
  double times(const JointRow& j, bool is_b) const {
    return static_cast<double>(n.dot(is_b ? j.dvb : j.dva) + r_n.dot(is_b ? j.dwb : j.dwa));
  }
};

}  // namespace

void JointMatrix::analyse(const std::vector<JointBodies>& joints) {
  joints_ = joints;
  const std::vector<JoinedBodies> bodies = bodies_of(joints);
  order_ = order_of_elimination(bodies);
  const std::vector<int> position = positions_in(order_);
  const std::vector<std::vector<int>> changed = changed_by_elimination(bodies, order_, position);
  lay_out(changed);
  updates_.clear();
  for (std::size_t i = 0; i < joints.size(); ++i) {
    columns_[i].updates = updates_.size();
    for (auto p = changed[i].begin(); p != changed[i].end(); ++p)
      for (auto q = p; q != changed[i].end(); ++q) updates_.push_back(values_at(*q, *p));
  }
  shared_.clear();
  for (const auto& [body, here] : joints_by_body(bodies)) {
    const auto is_b = [&, which = body](int joint) { return joints[static_cast<std::size_t>(joint)].b == which; };
    for (const int i : here)
      for (const int j : here)
        if (i == j || position[static_cast<std::size_t>(j)] < position[static_cast<std::size_t>(i)])
          shared_.push_back({i, j, is_b(i), is_b(j), values_at(i, j)});
  }
}

/// The columns of L with their blocks, and memory for all of it. `changed`: of each joint, the joints that its elimination
/// changes.
void JointMatrix::lay_out(const std::vector<std::vector<int>>& changed) {
  columns_.assign(joints_.size(), {});
  blocks_.clear();
  std::size_t row = 0, values = 0, largest = 0;
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const auto rows = static_cast<std::size_t>(joints_[i].rows);
    columns_[i].rows = joints_[i].rows;
    columns_[i].first = row;
    columns_[i].values = values;
    columns_[i].begin = blocks_.size();
    row += rows;
    values += rows * rows;
    const std::size_t below = values;
    for (const int other : changed[i]) {
      blocks_.push_back({other, values});
      values += rows * static_cast<std::size_t>(joints_[static_cast<std::size_t>(other)].rows);
    }
    columns_[i].end = blocks_.size();
    largest = std::max(largest, values - below);
  }
  values_.resize(values);
  before_.resize(largest);
  diagonal_.resize(row);
  inverse_pivots_.resize(row);
}

/// Where the block of two joints is in values_.
std::size_t JointMatrix::values_at(int row, int column) const {
  const Column& own = columns_[static_cast<std::size_t>(column)];
  if (row == column) return own.values;
  const auto begin = blocks_.begin() + std::ptrdiff_t(own.begin), end = blocks_.begin() + std::ptrdiff_t(own.end);
  return std::find_if(begin, end, [row](const Block& block) { return block.joint == row; })->values;
}

void JointMatrix::assemble(const JointRows& rows) {
  std::fill(values_.begin(), values_.end(), 0);
  for (const Shared& shared : shared_) {
    const Column &of_row = columns_[static_cast<std::size_t>(shared.row)],
                 &of_column = columns_[static_cast<std::size_t>(shared.column)];
    const bool on_diagonal = shared.row == shared.column;
    double* const values = &values_[shared.values];
    with_number(of_column.rows, [&](auto n) {
      for (int i = 0; i < of_row.rows; ++i) {
        const OfBody row(rows[of_row.first + std::size_t(i)], shared.row_is_b);
        const int end = on_diagonal ? i + 1 : int(n);
        for (int j = 0; j < end; ++j)
          values[i * n + j] += row.times(rows[of_column.first + std::size_t(j)], shared.column_is_b);
      }
    });
  }
  for (const Column& column : columns_)
    for (int i = 0; i < column.rows; ++i) {
      double& own = values_[column.values + std::size_t(i * column.rows + i)];
      own += static_cast<double>(rows[column.first + std::size_t(i)].softness);
      diagonal_[column.first + std::size_t(i)] = own;
    }
}

void JointMatrix::eliminate(const Column& column, const JointRows& rows, const std::vector<char>& active) {
  double* const l = &values_[column.values];
  double* const inverse = &inverse_pivots_[column.first];
  with_number(column.rows, [&](auto n) {
    for (int c = 0; c < n; ++c) {
      const std::size_t row = column.first + std::size_t(c);
      const double pivot = l[c * n + c], least = static_cast<double>(least_pivot) * diagonal_[row];
      const bool counts = active[row] && (pivot > least || has_limits(rows[row]));
      inverse[c] = counts && least > 0 ? 1 / std::max(pivot, least) : 0;
      for (int i = c + 1; i < n; ++i) {
        const double scaled = l[i * n + c] * inverse[c];
        for (int j = c + 1; j <= i; ++j) l[i * n + j] -= scaled * l[j * n + c];
      }
      for (int i = c + 1; i < n; ++i) l[i * n + c] *= inverse[c];
    }
    double* before = before_.data();  // of each block, L D
    for (std::size_t at = column.begin; at < column.end; ++at) {
      double* block = &values_[blocks_[at].values];
      for (int i = 0; i < rows_of(blocks_[at]); ++i, before += n, block += n) {
        for (int c = 0; c < n; ++c) {
          before[c] = block[c];
          for (int j = 0; j < c; ++j) before[c] -= before[j] * l[c * n + j];
        }
        for (int c = 0; c < n; ++c) block[c] = before[c] * inverse[c];
      }
    }
    const std::size_t* target = updates_.data() + column.updates;
    const double* of_p = before_.data();
    for (std::size_t p = column.begin; p < column.end; ++p) {
      const double* of_q = of_p;
      for (std::size_t q = p; q < column.end; ++q) {
        double* const changed = &values_[*target++];
        const double* const scaled = &values_[blocks_[p].values];
        with_number(rows_of(blocks_[p]), [&](auto p_rows) {
          for (int i = 0; i < rows_of(blocks_[q]); ++i, of_q += n) {
            const int end = q == p ? i + 1 : int(p_rows);
            for (int j = 0; j < end; ++j)
              for (int c = 0; c < n; ++c) changed[i * p_rows + j] -= of_q[c] * scaled[j * n + c];
          }
        });
      }
      of_p += rows_of(blocks_[p]) * n;
    }
  });
}

void JointMatrix::factor(const JointRows& rows, const std::vector<JointBodies>& joints,
                         const std::vector<char>& active) {
  if (joints != joints_) analyse(joints);
  assemble(rows);
  for (const int joint : order_) eliminate(columns_[static_cast<std::size_t>(joint)], rows, active);
}

void JointMatrix::solve(std::span<double> x) const {
  for (const int joint : order_) {
    const Column& column = columns_[static_cast<std::size_t>(joint)];
    const double* const l = &values_[column.values];
    double* const own = &x[column.first];
    with_number(column.rows, [&](auto n) {
      for (int i = 1; i < n; ++i)
        for (int j = 0; j < i; ++j) own[i] -= l[i * n + j] * own[j];
      for (std::size_t at = column.begin; at < column.end; ++at) {
        double* other = &x[columns_[static_cast<std::size_t>(blocks_[at].joint)].first];
        const double* block = &values_[blocks_[at].values];
        for (int i = 0; i < rows_of(blocks_[at]); ++i, block += n)
          for (int j = 0; j < n; ++j) other[i] -= block[j] * own[j];
      }
      for (int i = 0; i < n; ++i) own[i] *= inverse_pivots_[column.first + std::size_t(i)];
    });
  }
  for (auto joint = order_.rbegin(); joint != order_.rend(); ++joint) {
    const Column& column = columns_[static_cast<std::size_t>(*joint)];
    const double* const l = &values_[column.values];
    double* const own = &x[column.first];
    with_number(column.rows, [&](auto n) {
      for (std::size_t at = column.begin; at < column.end; ++at) {
        const double* other = &x[columns_[static_cast<std::size_t>(blocks_[at].joint)].first];
        const double* block = &values_[blocks_[at].values];
        for (int i = 0; i < rows_of(blocks_[at]); ++i, block += n)
          for (int j = 0; j < n; ++j) own[j] -= block[j] * other[i];
      }
      for (int i = n - 1; i >= 0; --i)
        for (int j = i + 1; j < n; ++j) own[i] -= l[j * n + i] * own[j];
    });
  }
}

std::size_t JointMatrix::nonzeros() const {
  std::size_t sum = 0;
  for (const Column& column : columns_) {
    sum += std::size_t(column.rows * (column.rows - 1) / 2);
    for (std::size_t at = column.begin; at < column.end; ++at) sum += std::size_t(column.rows * rows_of(blocks_[at]));
  }
  return sum;
}

}  // namespace pushback
