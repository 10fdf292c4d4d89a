/// The rows of all joints as one symmetric matrix of blocks, a block row for each joint.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "pushback/chapters/13_joints/joint_row.h"
#include "pushback/engine/direct/joint_graph.h"

namespace pushback {

/// Whether the impulse of a row has a limit.
inline bool has_limits(const Row& row) {
  return std::isfinite(row.lo) || std::isfinite(row.hi);
}

/// A = J M^-1 J^T + Gamma = L D L^T
///
/// Two joints share a block if they have a moving body in common. In a tree, each joint is eliminated before the joint that
/// connects it to the root. Then L has blocks only where A has them, and the time grows in proportion to the number of joints.
/// If joints form loops, the order is one of approximate minimum degree, and L has some more blocks. The order and the blocks
/// are kept while the same joints connect the same bodies.
///   Baraff, "Linear-time dynamics using Lagrange multipliers", SIGGRAPH 1996.
///
/// Rows may be redundant. 1 / D_i is the effective mass of row i if the rows before it hold, 1 / A_ii if there are no other
/// rows. If D_i < least_pivot A_ii, the rows before it already determine its speed, so it gets no impulse. A row with limits
/// may have another target speed than these rows, like a motor that drives against a stop. Then D_i is replaced by least_pivot
/// A_ii, and impulses grow until one of them reaches its limit.
class JointMatrix {
 public:
  static constexpr Real least_pivot = Real(std::numeric_limits<Real>::digits > 24 ? 1e-8 : 3e-4);  ///< of D_i / A_ii

  /// The bodies of a joint, `not_moving` for an immovable one, and the number of its rows.
  struct JointBodies {
    int a, b, rows;
    bool operator==(const JointBodies&) const = default;
  };
  /// Computes A from the rows, and L and D from A. `rows` contains the rows of the first joint, then of the second, and so on.
  /// Rows that are not `active` are left out.
  void factor(const JointRows& rows, const std::vector<JointBodies>& joints, const std::vector<char>& active);
  /// Solves A x = b. x is b at first. The numbers of rows that are not solved become 0.
  void solve(std::span<double> x) const;
  /// Whether a row is active and not redundant.
  bool is_solved(std::size_t row) const { return inverse_pivots_[row] != 0; }
  std::size_t solved_rows() const {
    return inverse_pivots_.size() - std::size_t(std::count(inverse_pivots_.begin(), inverse_pivots_.end(), 0.0));
  }
  /// The number of blocks of L below its diagonal.
  std::size_t off_diagonal_blocks() const { return blocks_.size(); }
  /// How many numbers of L below its diagonal may differ from 0.
  std::size_t nonzeros() const;

 private:
  struct Block {  // a block of L, in the column of one joint and the row of another
    int joint;
    std::size_t values;
  };
  struct Column {
    int rows;
    std::size_t first, values;  // index of its first row, and of its diagonal block in values_
    std::size_t begin, end;     // range of its blocks
    std::size_t updates;        // in updates_, for each pair of its blocks the values that its elimination changes
  };
  struct Shared {  // the contribution of a body that two joints share to a block of A
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

  std::vector<JointBodies> joints_;  // the graph of the latest analysis
  std::vector<int> order_;           // of elimination
  std::vector<Column> columns_;
  std::vector<Block> blocks_;
  std::vector<std::size_t> updates_;
  std::vector<Shared> shared_;
  std::vector<double> values_, inverse_pivots_, diagonal_, before_;
};

}  // namespace pushback
