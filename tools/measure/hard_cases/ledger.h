/// What the energy of a solve may do, whatever the scene and however few the sweeps.
///
/// A row that is solved changes its sum lambda by d, and the kinetic energy by exactly
///
///   dT = d JV + K d^2 / 2                                                     JV: before
///
/// It wants w = -(JV + b + gamma lambda) / (K + gamma) and gets d = theta w, 0 <= theta <= 1, where lambda lay within its
/// limits already: a clamp only stops it on the way. So d w >= d^2, and with JV = -(K + gamma) w - b - gamma lambda
///
///   dT <= -b d - gamma (lambda'^2 - lambda^2) / 2 - (K + gamma) d^2 / 2       with equality where nothing clamps
///
/// Nothing is assumed of the other rows, so the sum over a sweep holds for any number of rows and sweeps, converged or not:
/// energy comes in through b alone, the push-out speed or the bounce, and each row pays K d^2 / 2 for being solved.
///
/// Two things this does not cover, and the ledger goes on from what they leave:
///  - the start from old impulses does whatever work it does;
///  - where a contact has come to press less, the bound of its friction has shrunk below what it has already rubbed. It has to
///    give some of that back, though it might want more: no theta. That can return energy.
///
/// What is checked is each sweep over the normals, and each sweep over the tangents in which no bound had shrunk.
///
/// Where the bound of friction is a disc, its two rows change together by d, a step of 1/k that is then projected. With g = JV
/// before and k no less than either eigenvalue of the rows' block, a point of the disc is projected to one at which
/// g . d <= -k d . d, so
///
///   dT = g . d + d . (block) d / 2 <= -k d . d / 2
///
/// Where the normals are solved as often as it takes, each visit to a row obeys the inequality, and -b d and the term in gamma add
/// up over the visits; but what is paid does not follow from the sum of the d: at least nothing.
#pragma once

#include <string>

#include "pushback/chapters/08_friction_cone/friction_cone.h"
#include "pushback/chapters/09_impacts/simultaneous.h"
#include "pushback/chapters/12_soft_contacts/relaxing_solver.h"

namespace pushback {

/// Keeps the books of one solver. The effects below tell it where a solve has got to.
class Ledger {
 public:
  std::string broken;          ///< the first sweep that gained more than its rows allow; empty: none did
  bool repeated = false;       ///< normals are solved as often as it takes in a sweep
  bool cone = false;           ///< the bound of friction is a disc
  std::size_t normals = 0;     ///< so many rows, the first ones
  std::vector<Real> friction;  ///< mu of each contact that has tangents
  const std::vector<Real>* softness = nullptr;  ///< gamma of the first rows, 1/kg; none: they hold

  void open(const Rows& rows);        ///< no impulse yet
  void go_on_from(const Rows& rows);  ///< whatever has changed since: the old impulses are in, or the bodies have moved
  void normals_swept(const Rows& rows);   ///< each normal, by itself
  void tangents_swept(const Rows& rows);  ///< a sweep is over

 private:
  Real softness_of(std::size_t row) const { return softness && row < softness->size() ? (*softness)[row] : 0; }
  /// The bodies that the rows may move, once each, in the order of the world.
  void gather(const Rows& rows);
  Real energy() const;
  void balance(const char* what, const Rows& rows, std::size_t begin, std::size_t end);
  bool bounds_shrunk(const Rows& rows) const;

  std::vector<const Body*> bodies_;
  Real rounding_ = 0;  // relative
  Real now_ = 0;       // J, after what was booked last
  std::vector<Real> impulses_;
};

/// Instead of Friction or FrictionCone: the same, with the ledger told before and after.
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

/// The last effect: nothing acts after it in any hook.
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

/// A solver of which some effects keep books, all in one ledger.
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
