/// Treats an overlap as a spring with a damper. A relaxing pass removes the speed of the push-out.
#pragma once

#include "pushback/chapters/07_warm_start/full_solver.h"
#include "pushback/chapters/12_soft_contacts/carry.h"
#include "pushback/chapters/12_soft_contacts/relaxing_solver.h"

namespace pushback {

/// Replaces Baumgarte and Slop. In the list it comes before Restitution, which then adds the bounce, and before WarmStart.
///
///   k = w^2 / K,  c = 2 zeta w / K,  w = 2 pi hertz          a spring and a damper for the effective mass of the row, 1/K
///   J V + b + gamma lambda = 0                               both evaluated at the end of the step (implicit)
///   gamma = 1 / (h (c + h k)),  b = k / (c + h k) C          stable, however stiff
///
/// A contact that carries the force F rests at the depth d with k d = F. So a contact that carries a load overlaps and needs
/// no slop.
/// Catto, "Soft Constraints", GDC 2011. The relaxing pass is from Catto, "Solver2D", 2024.
struct SoftContacts : Effect, Relaxes {
  Real hertz = 240;           ///< of the spring; see angular_frequency
  Real damping_ratio = 5;     ///< zeta; 1: critical
  Real fastest_push_out = 3;  ///< m/s; so that a body deep inside another is not shot out

  /// w in steps of dt, rad/s. An oscillation has to take at least eight steps, so stiffer springs are softened.
  Real angular_frequency(Real dt) const { return 2 * pi * std::min(hertz, 1 / (8 * dt)); }

  void check(StepContext&) {
    require_positive("hertz", hertz);
    require_not_negative("damping ratio", damping_ratio);
    require_not_negative("fastest push-out", fastest_push_out);
  }
  void build(RelaxingContext& step) {
    const Real dt = step.dt;
    const Rows& rows = step.rows;
    const Real w = angular_frequency(dt);
    push_out_rate_ = w / (2 * damping_ratio + dt * w);          // k / (c + h k), in which the row's mass cancels
    gamma_by_K_ = 1 / (dt * w * (2 * damping_ratio + dt * w));  // gamma / K, likewise
    rigid_mass_.resize(step.contacts.size());
    apart_.resize(step.contacts.size());
    for (std::size_t i = 0; i < step.contacts.size(); ++i) {
      rigid_mass_[i] = rows[i].effective_mass;
      apart_[i] = rows[i].b->position - rows[i].a->position;
    }
  }
  /// Makes each contact that does not bounce a spring.
  void start(RelaxingContext& step) {
    Rows& rows = step.rows;
    bounce_.resize(rigid_mass_.size());
    for (std::size_t i = 0; i < rigid_mass_.size(); ++i) {
      bounce_[i] = rows[i].bias;
      if (bounce_[i] < 0 || rows[i].separation == 0) continue;
      const Real push_out = push_out_rate_ * rows[i].separation;
      rows[i].bias = std::max(push_out, -fastest_push_out);
      if (push_out < -fastest_push_out) continue;  // rigid, because a spring with a limit would sink for ever
      step.softness[i] = gamma_by_K_ / rigid_mass_[i];
      rows[i].effective_mass = rigid_mass_[i] / (1 + gamma_by_K_);  // 1 / (K + gamma)
    }
  }
  /// The push-out has moved the bodies. If its speed remained, it would add energy. So b becomes 0, or the bounce, and gamma 0.
  ///
  /// Angular momentum is conserved only if an impulse acts on both bodies at one point, with the inertias that they have now.
  void relax(RelaxingContext& step) {
    Rows& rows = step.rows;
    for (Row& row : rows) carry(row, row.b->position - row.a->position - apart_[row.owner]);
    for (std::size_t i = 0; i < rigid_mass_.size(); ++i) rows[i].bias = bounce_[i];
    std::fill(step.softness.begin(), step.softness.end(), Real(0));
  }

 private:
  Real push_out_rate_ = 0;  // 1/s
  Real gamma_by_K_ = 0;
  std::vector<Real> rigid_mass_;  // 1 / K, kg
  std::vector<Real> bounce_;      // b without the push-out, m/s
  std::vector<Vec3> apart_;       // x_B - x_A when the rows were made, m
};

/// FullSolver with soft contacts instead of Baumgarte and Slop.
using SoftSolver = RelaxingSolver<Clamping, SoftContacts, Restitution, Friction, WarmStart>;

}  // namespace pushback
