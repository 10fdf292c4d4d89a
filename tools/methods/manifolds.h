/// All normals of two bodies at once: the block solve of a manifold.
#pragma once

#include "pushback/tools/methods/visiting_solver.h"

namespace pushback {

/// In a VisitingSolver, beside Clamping. A visit to the first contact of two bodies solves their normals together, at most four:
///
///   r >= 0,   u = (W + e) r + q - e r_before >= 0,   r . u = 0
///
/// by principal pivoting: of the rows with the wrong sign, r_i < 0 or u_i < 0, the first changes sides, until there is none (K. G.
/// Murty, 1974; it ends where W + e is positive definite). Four corners of a face have a W of rank 3, so that r is not unique: e,
/// 1e-6 of the largest entry, makes it so, and takes the r that is nearest to the one before. Where nothing changes, e acts no more.
/// The idea is that of Box2D 2 for two points: E. Catto, b2ContactSolver, 2007. The constant e is ours.
struct Manifolds : Effect {
  void build(StepContext& step);
  void visit(StepContext& step, std::size_t i);

 private:
  static constexpr int most = 4;
  template <int Columns>
  using Small = Eigen::Matrix<Real, Eigen::Dynamic, Columns, Eigen::ColMajor, most, Columns == 1 ? 1 : most>;
  struct Block {
    int size;                 // 0: of a contact that is not the first of its bodies
    Small<Eigen::Dynamic> w;  // 1/kg, with e
    Real pull;                // e, 1/kg
  };
  /// r; `q` without the part of r.
  static Small<1> solve(const Small<Eigen::Dynamic>& w, const Small<1>& q, const Small<1>& before);

  std::vector<Block> blocks_;  // one a contact
};

}  // namespace pushback
