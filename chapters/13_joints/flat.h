/// The whole solver of chapters 01 to 13, except 09 and 10, as a plain loop. A test checks that it gives the same bits as
/// Substeps<RelaxingSolver<Joints, Clamping, SoftContacts, Restitution, FrictionCone, WarmStart>>. It omits sleep. It also omits
/// the count of rows solved and the state of each contact, which the pictures show, because no impulse depends on them.
#pragma once

#include <limits>
#include <vector>

#include "pushback/common/world/step_solver.h"

namespace pushback::flat_13 {

inline constexpr Real inf = std::numeric_limits<Real>::infinity();

/// One direction of one contact, or one equation of a joint.
///  J = [ -n  -(r_A x n)  n  (r_B x n) ],   V = (v_A, w_A, v_B, w_B),   K = J M^-1 J^T
struct Row {
  std::size_t contact = 0;    // index of its contact, and of that contact's normal row
  Body *a, *b;                // the contact's normal points from A to B
  Vec3 n, ra_n, rb_n;         // J; n: the row's direction, unit, world axes; 0 for angular equations
  Vec3 dva, dwa, dvb, dwb;    // M^-1 J^T: the change of each velocity by an impulse of 1 N s
  Real effective_mass;        // 1 / K, kg
  Real bias = 0;              // 03: b, minus the target separating speed, m/s
  Real bounce = 0;            // 12: b without the push-out, m/s
  Real softness = 0;          // 12: gamma, 1/kg
  Real separation = 0;        // 12: C, m
  Vec3 apart = Vec3::Zero();  // 12: x_B - x_A when the row was placed, m
  Real lo = -inf, hi = inf;   // 02: limits of the sum, N s
  Real impulse = 0;           // sum(lambda) over all sweeps of this step, N s
};

class FlatSolver : public StepSolver {
 public:
  Real threshold = Real(0.1);   ///< 05: m/s; a slower contact does not bounce
  int substeps = 32;            ///< 11: of each step
  Real hertz = 240;             ///< 12: frequency of the spring at an overlap
  Real damping_ratio = 5;       ///< 12: zeta of its damper; 1: critical
  Real fastest_push_out = 3;    ///< 12: m/s
  Real joint_beta = Real(0.2);  ///< 13: the fraction of a joint's C that one step removes

  bool supports_joints() const override { return true; }  ///< 13
  /// 11: `substeps` substeps of one sweep in each step. Each substep detects the contacts again.
  Plan plan(Real /*dt*/) const override { return {.detections = substeps, .sweeps = 1}; }
  void solve(World& world, Real dt, int sweeps) override;
  void after_move(World& world, Real dt) override;  ///< 12

 private:
  void make_rows(World& world);
  void add_springs(Real dt);                    // 12
  void make_joint_rows(World& world, Real dt);  // 13
  void guess_impulses(World& world, Real dt);   // 07
  void sweep(const Contacts& contacts, int sweeps);
  void keep_impulses(Contacts& contacts);

  std::vector<Row> normals_;      // one for each contact
  std::vector<Row> tangents_;     // 06: two for each contact with friction
  std::vector<Real> step_sizes_;  // 08: 1 / k of each pair of tangents, kg
  std::vector<Row> joints_;       // 13: one for each equation of each joint
  Equations equations_;           // 13: of all joints
};

}  // namespace pushback::flat_13
