/// The whole solver of chapters 01 to 06 as a plain loop, without effects or hooks. A test checks that it gives the same
/// bits as Solver<Clamping, Baumgarte, Slop, Restitution, Friction>. It omits the count of rows solved and the state of
/// each contact, which the pictures show, because no impulse depends on them.
#pragma once

#include <limits>
#include <vector>

#include "pushback/common/world/step_solver.h"

namespace pushback::flat_06 {

inline constexpr Real inf = std::numeric_limits<Real>::infinity();

/// One direction of one contact.   J = [ -n  -(r_A x n)  n  (r_B x n) ],   V = (v_A, w_A, v_B, w_B),   K = J M^-1 J^T
struct Row {
  std::size_t contact;       // index of its contact, and of that contact's normal row
  Body *a, *b;               // the contact's normal points from A to B
  Vec3 n, ra_n, rb_n;        // J; n: the row's direction, unit, world axes
  Vec3 dva, dwa, dvb, dwb;   // M^-1 J^T: the change of each velocity by an impulse of 1 N s
  Real effective_mass;       // 1 / K, kg
  Real bias;                 // 03: b, minus the target separating speed, m/s
  Real lo = -inf, hi = inf;  // 02: limits of the sum, N s
  Real impulse = 0;          // sum(lambda) over all sweeps of this step, N s
};

class FlatSolver : public StepSolver {
 public:
  Real beta = Real(0.2);       ///< 03: the fraction of the overlap that one step removes
  Real slop = Real(0.005);     ///< 04: m, the overlap that is not corrected
  Real threshold = Real(0.1);  ///< 05: m/s; a slower contact does not bounce

  void solve(World& world, Real dt, int sweeps) override;

 private:
  std::vector<Row> normals_;   // one for each contact
  std::vector<Row> tangents_;  // 06: two for each contact with friction
};

}  // namespace pushback::flat_06
