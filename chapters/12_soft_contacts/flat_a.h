/// Chapter 12a's solver as a plain loop, in which each overlap is a spring with a damper. A test checks that it gives the same
/// bits as Substeps<RelaxingSolver<Clamping, SoftContacts, Restitution, FrictionCone, WarmStart>> without its relaxing pass.
#pragma once

#include <limits>
#include <vector>

#include "pushback/common/world/step_solver.h"

namespace pushback::flat_12a {

inline constexpr Real inf = std::numeric_limits<Real>::infinity();

/// One direction of one contact.   J = [ -n  -(r_A x n)  n  (r_B x n) ],   V = (v_A, w_A, v_B, w_B),   K = J M^-1 J^T
struct Row {
  std::size_t contact;       // index of its contact, and of that contact's normal row
  Body *a, *b;               // the contact's normal points from A to B
  Vec3 n, ra_n, rb_n;        // J; n: the row's direction, unit, world axes
  Vec3 dva, dwa, dvb, dwb;   // M^-1 J^T: the change of each velocity by an impulse of 1 N s
  Real effective_mass;       // 1 / K, kg
  Real bias = 0;             // 03: b, minus the target separating speed, m/s
  Real softness = 0;         // 12: gamma, 1/kg
  Real separation = 0;       // 12: C, m
  Real lo = -inf, hi = inf;  // 02: limits of the sum, N s
  Real impulse = 0;          // sum(lambda) over all sweeps of this step, N s
};

class FlatSolver : public StepSolver {
 public:
  Real threshold = Real(0.1);  ///< 05: m/s; a slower contact does not bounce
  int substeps = 32;           ///< 11: of each step
  Real hertz = 240;            ///< 12: frequency of the spring at an overlap
  Real damping_ratio = 5;      ///< 12: zeta of its damper; 1: critical
  Real fastest_push_out = 3;   ///< 12: m/s

  /// 11: `substeps` substeps of one sweep in each step. Each substep detects the contacts again.
  Plan plan(Real /*dt*/) const override { return {.detections = substeps, .sweeps = 1}; }
  void solve(World& world, Real dt, int sweeps) override;

 private:
  void make_rows(World& world);
  void add_springs(Real dt);                   // 12
  void guess_impulses(World& world, Real dt);  // 07
  void sweep(const Contacts& contacts, int sweeps);
  void keep_impulses(Contacts& contacts);

  std::vector<Row> normals_;      // one for each contact
  std::vector<Row> tangents_;     // 06: two for each contact with friction
  std::vector<Real> step_sizes_;  // 08: 1 / k of each pair of tangents, kg
};

}  // namespace pushback::flat_12a
