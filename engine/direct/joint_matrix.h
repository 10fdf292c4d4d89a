/// The rows of all joints as one symmetric matrix of blocks, a block row for each joint.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "pushback/chapters/13_joints/joint_row.h"
#include "pushback/engine/direct/joint_graph.h"

namespace pushback {

/// Whether there are limits to its impulse.
inline bool has_limits(const Row& row) {
  return std::isfinite(row.lo) || std::isfinite(row.hi);
}

/// A = J M^-1 J^T + Gamma = L D L^T
///
/// Two joints share a block where they hold the same moving body. A joint is eliminated before the one that it hangs from, so L has
/// a block where A has one, and no other: a tree of n joints takes a time that grows as n. Where joints form loops, the order is
/// that of an approximate minimum degree, and L has some blocks more. Both are found once, and stay while the same joints
/// hold the same bodies.   Baraff, "Linear-time dynamics using Lagrange multipliers", SIGGRAPH 1996.
///
/// Rows may ask for the same thing twice. 1 / D_i is the mass that row i feels while the rows before it hold, 1 / A_ii what it feels
/// alone. A row that feels 1 / least_pivot times as much gets no impulse: the others hold it. If it has limits, it may ask for another
/// speed than they do, as a motor that drives against a stop. Then its D_i counts as least_pivot A_ii, and impulses grow until one of
/// them is at its limit.
class JointMatrix {
 public:
  static constexpr Real least_pivot = Real(std::numeric_limits<Real>::digits > 24 ? 1e-8 : 3e-4);  ///< of D_i / A_ii

  /// What a joint holds: two bodies by their indices, `not_moving` for one that cannot move, and with how many rows.
  struct JointBodies {
    int a, b, rows;
    bool operator==(const JointBodies&) const = default;
  };
  /// Makes A of the rows, and L and D of A. `rows` are those of the first joint, then those of the second, and so on. A row that is not
  /// `active` is as if it were not there.
  void factor(const JointRows& rows, const std::vector<JointBodies>& joints, const std::vector<char>& active);
  /// A x = b, for the rows that count; 0 for the others. x is b at first.
  void solve(std::span<double> x) const;
  /// Whether a row is solved: it was active, and asks for what none before it has asked for.
  bool is_solved(std::size_t row) const { return inverse_pivots_[row] != 0; }
  std::size_t solved_rows() const {
    return inverse_pivots_.size() - std::size_t(std::count(inverse_pivots_.begin(), inverse_pivots_.end(), 0.0));
  }
  /// Blocks of L below its diagonal.
  std::size_t off_diagonal_blocks() const { return blocks_.size(); }
  /// Numbers of L below its diagonal that may differ from 0.
  std::size_t nonzeros() const;

 private:
  struct Block {  // of L, in the column of a joint: of the joint that it changes
    int joint;
    std::size_t values;
  };
  struct Column {
    int rows;
    std::size_t first, values;  // of its rows; of its block on the diagonal, in values_
    std::size_t begin, end;     // of its blocks
    std::size_t updates;        // in updates_: of each pair of its blocks, the values that its elimination changes
  };
  struct Shared {  // what two joints have in common
    int row, column;
    bool row_is_b, column_is_b;
    std::size_t values;
  };
  int rows_of(const Block& block) const { return columns_[static_cast<std::size_t>(block.joint)].rows; }
  void analyse(const std::vector<JointBodies>& joints);
  void lay_out(const std::vector<std::vector<int>>& changed);
  std::size_t values_at(int row, int column) const;
  void assemble(const JointRows& rows);
  void eliminate(const Column& column, const JointRows& rows, const std::vector<char>& active);

  std::vector<JointBodies> joints_;  // what it was analysed for
  std::vector<int> order_;           // of elimination
  std::vector<Column> columns_;
  std::vector<Block> blocks_;
  std::vector<std::size_t> updates_;
  std::vector<Shared> shared_;
  std::vector<double> values_, inverse_pivots_, diagonal_, before_;
};

}  // namespace pushback
