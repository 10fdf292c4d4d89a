/// The whole solver of chapter 01 as a plain loop, without effects or hooks. A test checks that it gives the same bits as
/// Solver<>. It omits the count of rows solved, on which no impulse depends.
#pragma once

#include <vector>

#include "pushback/common/world/step_solver.h"

namespace pushback::flat_01 {

/// One direction of one contact.   J = [ -n  -(r_A x n)  n  (r_B x n) ],   V = (v_A, w_A, v_B, w_B),   K = J M^-1 J^T
struct Row {
  std::size_t contact;      // index of its contact, and of that contact's normal row
  Body *a, *b;              // the contact's normal points from A to B
  Vec3 n, ra_n, rb_n;       // J; n: the row's direction, unit, world axes
  Vec3 dva, dwa, dvb, dwb;  // M^-1 J^T: the change of each velocity by an impulse of 1 N s
  Real effective_mass;      // 1 / K, kg
  Real impulse = 0;         // sum(lambda) over all sweeps of this step, N s
};

class FlatSolver : public StepSolver {
 public:
  void solve(World& world, Real dt, int sweeps) override;

 private:
  std::vector<Row> normals_;  // one for each contact
};

}  // namespace pushback::flat_01
