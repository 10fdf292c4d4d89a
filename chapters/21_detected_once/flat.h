/// The whole solver of this chapter as a plain loop, with everything that it needs of chapters 01 to 14, to show how it works. A
/// test compares it with DetectedOnce. It omits sleep, the checks of settings, and data on which no impulse depends: the count
/// of rows solved, and the state of each contact, which the pictures show.
#pragma once

#include <limits>
#include <vector>

#include "pushback/common/world/step_solver.h"

namespace pushback::flat_21 {

inline constexpr Real inf = std::numeric_limits<Real>::infinity();

/// One direction of one contact, or one equation of a joint.
///  J = [ -n  -(r_A x n)  n  (r_B x n) ],   V = (v_A, w_A, v_B, w_B),   K = J M^-1 J^T
struct Row {
  std::size_t contact = 0;    // index of its contact, and of that contact's normal row
  Body *a, *b;                // the contact's normal points from A to B
  Vec3 n, ra_n, rb_n;         // J; n: the row's direction, unit, world axes; 0 for angular equations
  Vec3 dva, dwa, dvb, dwb;    // M^-1 J^T: what an impulse of 1 N s adds to each velocity
  Real effective_mass;        // 1 / K, kg; 12: 1 / (K + gamma)
  Real rigid_mass;            // 21: 1 / K, kg
  Real bias = 0;              // 03: b, m/s: minus the wanted separating speed
  Real bounce = 0;            // 05: minus the speed after the bounce, m/s; 0: it does not bounce
  Real softness = 0;          // 12: gamma, 1/kg
  Real push_out = 0;          // 14: (beta / h) C of a joint, m/s, separate from b
  Real* kept = nullptr;       // 14: the impulse that its joint stores, N s
  Vec3 apart = Vec3::Zero();  // 12: x_B - x_A when the row was placed, m
  Real lo = -inf, hi = inf;   // 02: limits of the sum, N s
  Real impulse = 0;           // sum(lambda), N s: over all sweeps and substeps of this step
  Real start = 0;             // 21: at the start of the substep, N s
  Real found = 0;             // 21: C at detection, m
};

/// 21: the displacement of a body since contacts were detected.
struct Moved {
  Vec3 way = Vec3::Zero();   // sum of h v, m
  Vec3 turn = Vec3::Zero();  // sum of h w, rad
};

class FlatSolver : public StepSolver {
 public:
  Real threshold = Real(0.1);      ///< 05: m/s; what arrives slower does not bounce
  Real precision = Real(1e-6);     ///< 09: to which an impact is solved, of the fastest bounce,
  int most_rounds = 100;           ///< 09: or until it has been swept so often
  int substeps = 32;               ///< 11: of each step
  Real hertz = 240;                ///< 12: of the spring that an overlap is
  Real damping_ratio = 5;          ///< 12: zeta of its damper; 1: critical
  Real fastest_push_out = 3;       ///< 12: m/s
  Real joint_beta = Real(0.2);     ///< 13: the fraction of a joint's C that one step removes
  int passes = 20;                 ///< 14: over the joints, in each sweep
  Real margin = Real(0.02);        ///< 21: m, added to the distance that a pair may approach in one step
  Real carried_from = Real(1e-3);  ///< 21: m/s; bodies with a lower relative velocity keep their rows

  bool holds_joints() const override { return true; }  ///< 13
  /// 11: many substeps of one sweep. 21: contacts are detected once for all of them.
  Plan plan(Real dt) const override {
    return {.substeps = substeps, .sweeps = 1, .margin = {.least = margin, .ahead = dt}};
  }
  void detected(World& world, Real h) override;  ///< 21: once per step
  void solve(World& world, Real h, int sweeps) override;
  void moved(World& world, Real h) override;  ///< 12
  void done(World& world) override;           ///< 21: once per step

 private:
  void make_contact_rows(World& world);
  void guess_impulses(World& world, Real h);
  void prepare_normals(const Contacts& contacts, Real h);
  void prepare_joints(World& world, Real h);
  void forget_impacts();
  Real separation(const Row& normal) const;
  void sweep(const Contacts& contacts, int sweeps);

  std::vector<Row> normals_;      // one for each contact
  std::vector<Row> tangents_;     // 06: two for each contact that can rub
  std::vector<Real> step_sizes_;  // 08: of each two of them, 1 / k, kg
  std::vector<Row> joints_;       // 13: one for each equation of each joint
  Equations equations_;           // 13: of all joints
  std::vector<Moved> moved_;      // 21: of each body
  std::vector<Vec3> sums_;        // 21: of each contact, N s: over the substeps so far
  Real fastest_ = 0;              // 09: bounce in this substep, m/s; 0: nothing bounces
};

}  // namespace pushback::flat_21
