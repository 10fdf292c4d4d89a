/// A matrix of blocks, a row and a column of blocks for each body.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <utility>
#include <vector>

namespace pushback {

/// A = L U in blocks of 6 x 6, for six velocities per body. Two bodies share a block if a contact or joint acts between them. L and U
/// have some further blocks, which an approximate minimum degree ordering keeps few. There are far fewer blocks between bodies than
/// between contacts. The order is computed once and kept while the same bodies share blocks.
class BodyMatrix {
 public:
  using Block = Eigen::Matrix<double, 6, 6>;
  using Six = Eigen::Matrix<double, 6, 1>;
  using Pairs = std::vector<std::pair<int, int>>;

  /// Sets A to the identity. `pairs`: indices of bodies that share a block, each below `bodies`, the lower one first. Returns false,
  /// and makes no matrix, if `factor` would take more than `most` multiplications. This check takes far fewer.
  bool begin(int bodies, const Pairs& pairs, double most = std::numeric_limits<double>::infinity());
  /// Adds to the block in the row of one body and the column of another. Both are the same body or one of `pairs`.
  void add(int row, int column, const Block& block);
  /// Factors A without pivoting between bodies. Returns false if a block on the diagonal is singular.
  bool factor();
  /// Solves A x = b, after `factor`. x is b at first.
  void solve(std::vector<Six>& x) const;
  /// The multiplications that `factor` and `solve` take, known after `begin`.
  double of_factor() const { return of_factor_; }
  double of_solve() const { return 36 * static_cast<double>(columns_.size() + 2 * entries_.size()); }

 private:
  struct Entry {  // a block below the diagonal and its mirror image, for an eliminated body and one that comes later
    int later;
    Block lower = Block::Zero(), upper = Block::Zero();
  };
  struct Column {
    std::size_t begin, end;  // in entries_
    std::size_t updates;     // in updates_, for each pair of its entries the entry that its elimination changes
    Block diagonal;          // after `factor`, its inverse
  };
  void analyse(int bodies, const Pairs& pairs, double most);
  bool earlier(int one, int other) const {
    return position_[static_cast<std::size_t>(one)] < position_[static_cast<std::size_t>(other)];
  }
  Entry& entry_of(int one, int other);
  Column& column_of(int body) { return columns_[static_cast<std::size_t>(body)]; }
  const Column& column_of(int body) const { return columns_[static_cast<std::size_t>(body)]; }

  Pairs pairs_;                // the pairs of the latest analysis
  std::vector<int> order_;     // of elimination
  std::vector<int> position_;  // of each body, in order_
  std::vector<Column> columns_;
  std::vector<Entry> entries_;
  std::vector<std::size_t> updates_;
  double of_factor_ = 0;  // if not `whole_`, the multiplications counted so far
  bool whole_ = false;    // false if counting stopped, because there were too many
};

}  // namespace pushback
