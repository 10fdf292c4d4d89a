/// The common part of the solvers of chapters 21 and 22, which detect contacts once per step.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "pushback/chapters/12_soft_contacts/soft_contacts.h"
#include "pushback/chapters/13_joints/joint_row.h"

namespace pushback {

/// The coefficients of all soft contacts for one length of substep: see SoftContacts, chapter 12.
struct PushOut {
  Real rate;        ///< k / (c + h k), 1/s
  Real gamma_by_K;  ///< gamma / K
  Real fastest;     ///< m/s
  Real threshold;   ///< m/s; slower contacts do not bounce
};

/// The state that a picture shows at a contact point. `known`: whether the previous step had this contact.
template <class Scalar>
ContactState state_of(bool known, Scalar friction, Scalar pushed, Scalar rubbed1, Scalar rubbed2) {
  if (!known) return ContactState::fresh;
  if (friction == 0) return ContactState::warm;
  constexpr Scalar rounding = 16 * std::numeric_limits<Scalar>::epsilon();  // of a projection to the cone
  const bool held = std::sqrt(rubbed1 * rubbed1 + rubbed2 * rubbed2) < (1 - rounding) * friction * pushed;
  return held ? ContactState::sticking : ContactState::sliding;
}

/// An impulse of the previous step, N s, moved into the friction cone, because the normal may have rotated since. The tangential
/// part is shortened, and an impulse that pulls becomes 0. A substep with a bounce restores its initial impulses, so these must
/// be in the cone.
inline Vec3 clamped_to_cone(const Vec3& impulse, const Vec3& n, Real friction) {
  const Real pressed = std::max(Real(0), impulse.dot(n));
  const Vec3 rubbed = impulse - impulse.dot(n) * n;
  const Real size = rubbed.norm();
  return pressed * n + (size > friction * pressed ? friction * pressed / size : 1) * rubbed;
}

/// The settings and plan of a solver that divides its steps into substeps of one sweep. Contacts are detected within a margin, so
/// that bodies that touch later in the step have rows.
struct Substepping {
  /// The substeps of a step of `reference_step`, s. A longer step has more and a shorter one fewer, so that contacts are equally
  /// stiff. If reference_step is 0, each step has this number, whatever its length.
  int substeps = 32;
  Real reference_step = 0;
  Real margin = Real(0.02);    ///< m, added to the distance by which a pair may approach in one step
  Real threshold = Real(0.1);  ///< m/s; slower contacts do not bounce
  /// In a substep with a bounce, normals are solved until no speed changes by more than this fraction of the fastest bounce.
  Real precision = Real(1e-6);
  /// In other substeps, normals are solved again if a pass has changed a speed by more than this, m/s.
  Real recheck_speed = std::numeric_limits<Real>::infinity();
  int most_rounds = 100;  ///< passes over the normals in a sweep
  SoftContacts spring;    ///< chapter 12's frequency, damping ratio and fastest push-out

  static bool supports_joints() { return true; }
  /// Throws InvalidInput if a setting cannot be used.
  void check_settings(World& world, Real h) {
    if (substeps < 1) throw InvalidInput(fmt::format("substeps is {}: a whole number, 1 or more, is needed", substeps));
    require_not_negative("reference_step", reference_step);
    require_not_negative("margin", margin);
    require_not_negative("threshold", threshold);
    require_not_negative("precision", precision);
    if (!(recheck_speed > 0))
      throw InvalidInput(fmt::format("recheck_speed is {}: more than 0 is needed", recheck_speed));
    if (most_rounds < 1)
      throw InvalidInput(fmt::format("most_rounds is {}: a whole number, 1 or more, is needed", most_rounds));
    StepContext step = joints_step(world, h);
    spring.check(step);
  }
  Plan plan(Real dt) const {
    const Real parts = reference_step > 0 ? static_cast<Real>(substeps) * dt / reference_step * (1 - rounding)
                                          : static_cast<Real>(substeps);
    // dt may have any value, because `plan` is called before dt is checked.
    const Real finite = parts < most_substeps ? parts : most_substeps;
    return {.substeps = std::max(1, static_cast<int>(std::ceil(finite))),
            .sweeps = 1,
            .margin = {.least = margin, .ahead = dt}};
  }

 protected:
  static SolveStats stats_of(const JointRows& rows) {
    SolveStats sum{static_cast<int>(rows.size()), 0};
    for (const JointRow& row : rows) sum.residual = std::max(sum.residual, row.error());
    return sum;
  }
  /// Joints build their own rows in each substep and do not read the contacts, so the list of contact rows is empty.
  StepContext joints_step(World& world, Real h) { return {world, world.contacts, no_rows_, h}; }
  PushOut push_out(Real h) const {
    const Real w = spring.angular_frequency(reference_step > 0 ? reference_step / static_cast<Real>(substeps) : h),
               damping = 2 * spring.damping_ratio + h * w;
    return {w / damping, 1 / (h * w * damping), spring.fastest_push_out, threshold};
  }
  /// Calls `act(i, p)` for each contact that the previous step had. p: its initial impulse, N s.
  template <class Act>
  void start_from_last_step(const World& world, Real h, const Act& act) {
    const Real scale = world.impulse_scale(h);
    known_.assign(world.contacts.size(), false);
    auto old = world.contacts_before.begin();  // both lists ascend, so go through them in parallel
    for (std::size_t i = 0; i < world.contacts.size(); ++i) {
      const ContactId id = world.contacts[i].id;
      while (old != world.contacts_before.end() && old->id < id) ++old;
      if (old == world.contacts_before.end() || old->id != id) continue;
      known_[i] = true;
      act(i, scale * old->impulse);
    }
  }
  /// `pass()` solves all normals once and returns the largest change of a speed, m/s. It is called once, and then again up to
  /// `most_rounds` times. In a substep with a bounce it repeats until `precision` is reached, as in chapter 09, otherwise while the
  /// change is above `recheck_speed` and does not grow.
  template <class Pass>
  void solve_normals_until_solved(const Pass& pass) const {
    Real change = pass();
    const bool bounces = fastest_ > 0;
    const Real enough = bounces ? precision * fastest_ : recheck_speed, growing = 2 * change;
    for (int round = 1; round < most_rounds && change > enough && (bounces || change <= growing); ++round)
      change = pass();
  }

  std::vector<bool> known_;  // for each contact, whether the previous step had it
  Real fastest_ = 0;         // fastest bounce of this substep, m/s; 0: none

 private:
  static constexpr Real rounding = Real(1e-5);      // a step that is longer by this fraction gets no further substep
  static constexpr Real most_substeps = Real(1e6);  // in a step
  Rows no_rows_;
};

}  // namespace pushback
