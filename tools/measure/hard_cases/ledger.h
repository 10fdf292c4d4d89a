/// Bounds on the change of kinetic energy by a solve, for any scene and any number of sweeps.
///
/// A row that is solved changes its sum lambda by d, and the kinetic energy by exactly
///
///   dT = d JV + K d^2 / 2                                                     JV: before the solve
///
/// The unclamped change is w = -(JV + b + gamma lambda) / (K + gamma). If lambda was within its limits, a clamp only reduces it, so
/// d = theta w with 0 <= theta <= 1. Hence d w >= d^2, and with JV = -(K + gamma) w - b - gamma lambda
///
///   dT <= -b d - gamma (lambda'^2 - lambda^2) / 2 - (K + gamma) d^2 / 2       with equality if nothing clamps
///
/// Nothing is assumed about other rows, so the sum over a sweep holds for any number of rows and sweeps, converged or not. Only b, the
/// push-out speed or the bounce, adds energy, and each solve of a row dissipates K d^2 / 2.
///
/// The bound does not cover two changes, after which the ledger continues with the present energy:
///  - The warm start may do any work.
///  - If the normal impulse of a contact decreases, the limit of its friction falls below the accumulated friction impulse. Part of
///    that impulse has to be taken back, even if the unclamped change has the other sign, so there is no theta. That can add energy.
///
/// The ledger checks each sweep over the normals, and each sweep over the tangents in which no limit had decreased.
///
/// If the friction limit is a disc, its two rows change together by d, a step of 1/k that is then projected. Let g be JV before the
/// step, and let k be at least as large as both eigenvalues of the rows' block. From a point in the disc, the projected step satisfies
/// g . d <= -k d . d, so
///
///   dT = g . d + d . (block) d / 2 <= -k d . d / 2
///
/// If the normals are solved repeatedly within a sweep, each solve of a row satisfies the inequality, and -b d and the term in gamma add
/// up over these solves. The dissipated energy does not follow from the sum of the d, so only 0 is assumed for it.
#pragma once

#include <string>

#include "pushback/chapters/08_friction_cone/friction_cone.h"
#include "pushback/chapters/09_impacts/simultaneous.h"
#include "pushback/chapters/12_soft_contacts/relaxing_solver.h"

namespace pushback {

/// Checks the energy balance of one solver. The effects below report the stages of a solve to it.
class Ledger {
 public:
  std::string broken;          ///< the first sweep that added more energy than its rows allow, or empty
  bool repeated = false;       ///< whether normals are solved repeatedly within a sweep
  bool cone = false;           ///< whether the friction limit is a disc
  std::size_t normals = 0;     ///< the number of normal rows, which come first
  std::vector<Real> friction;  ///< mu of each contact that has tangents
  const std::vector<Real>* softness = nullptr;  ///< gamma of the first rows, 1/kg, or null if they are rigid

  void open(const Rows& rows);            ///< call it before any impulse
  void go_on_from(const Rows& rows);      ///< after a warm start, or after the bodies have moved
  void normals_swept(const Rows& rows);   ///< after each normal has been solved by itself
  void tangents_swept(const Rows& rows);  ///< at the end of a sweep

 private:
  Real softness_of(std::size_t row) const { return softness && row < softness->size() ? (*softness)[row] : 0; }
  /// The bodies that the rows may move, once each, in the order of the world.
  void gather(const Rows& rows);
  Real energy() const;
  void balance(const char* what, const Rows& rows, std::size_t begin, std::size_t end);
  bool bounds_shrunk(const Rows& rows) const;

  std::vector<const Body*> bodies_;
  Real rounding_ = 0;  // relative to the energies
  Real now_ = 0;       // J, after the latest report
  std::vector<Real> impulses_;
};

/// Replaces Friction or FrictionCone. The same effect, which reports to the ledger before and after it acts.
template <class OneFriction>
struct Booked : OneFriction {
  Ledger* ledger = nullptr;
  void build(StepContext& step) {
    OneFriction::build(step);
    ledger->normals = step.contacts.size();
    ledger->friction = this->mu_;
    ledger->cone = std::derived_from<OneFriction, FrictionCone>;
  }
  void sweep(StepContext& step) {
    ledger->normals_swept(step.rows);
    OneFriction::sweep(step);
    ledger->tangents_swept(step.rows);
  }
};

/// Has to be the last effect, so that nothing acts after it in any hook.
struct Bookkeeper : Effect {
  Ledger* ledger = nullptr;
  void build(StepContext& step) { ledger->open(step.rows); }
  void start(StepContext& step) { ledger->go_on_from(step.rows); }
};
/// The same for a solver that relaxes.
struct RelaxingBookkeeper : Bookkeeper, Relaxes {
  void build(RelaxingContext& step) {
    ledger->softness = &step.softness;
    Bookkeeper::build(step);
  }
  void relax(RelaxingContext& step) { ledger->go_on_from(step.rows); }
};

/// A solver some of whose effects report to one ledger.
template <template <class...> class SolverOf, class... Effects>
struct BookedSolver : SolverOf<Effects...> {
  explicit BookedSolver(Ledger& ledger) {
    ledger.repeated = std::derived_from<BookedSolver, SimultaneousImpacts>;
    (hand_to(static_cast<Effects&>(*this), ledger), ...);
  }

 private:
  template <class E>
  static void hand_to(E& effect, Ledger& ledger) {
    if constexpr (requires { effect.ledger; }) effect.ledger = &ledger;
  }
};

}  // namespace pushback
