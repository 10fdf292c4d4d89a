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
/// Two things this does not cover, and the ledger enters them as what they are:
///  - the start from old impulses does whatever work it does;
///  - where a contact has come to press less, the bound of its friction has shrunk below what it has already rubbed. It has to
///    give some of that back, though it might want more: no theta. That can return energy, and is counted apart.
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
///
/// Where the start is scaled, it is held to what it promises, of the rows as they then are:
///
///   f = lambda . (A + Gamma) lambda / 2 + lambda . (J V + b) <= 0      which is dT + b . lambda + lambda . Gamma lambda / 2
#pragma once

#include <string>

#include "pushback/chapters/07_warm_start/scaled.h"
#include "pushback/chapters/08_friction_cone/friction_cone.h"
#include "pushback/chapters/09_impacts/simultaneous.h"
#include "pushback/chapters/12_soft_contacts/relaxing_solver.h"

namespace pushback {

/// What was seen in all solves. Shares are of the larger of the kinetic energies before and after.
struct Account {
  std::string broken;      ///< the first sweep that gained more than its rows allow; empty: none did
  long solves = 0;         ///< with at least one contact
  long started_above = 0;  ///< of them, those in which the old impulses raised the kinetic energy
  Real most_started = 0;   ///< the largest share by which they did
  long returned = 0;       ///< those in which a sweep of friction gave energy back
  Real most_returned = 0;  ///< the largest share in one solve
  long ended_above = 0;    ///< those that ended above their start plus what b may feed in, by more than rounding
  Real most_above = 0;     ///< the largest share of it
  void add(const Account& other);
};

/// Keeps the books of one solver. The effects below tell it where a solve has got to.
class Ledger {
 public:
  Account account;
  bool cone = false;  ///< the bound of friction is a disc

  void open(const Rows& rows);            ///< no impulse yet
  void guess_scaled(const Rows& rows);    ///< the old impulses are in, and must not make things worse
  void started(const Rows& rows);         ///< the old impulses are in
  void reopened(const Rows& rows);        ///< the bodies have moved, the rows may have changed
  void normals_swept(const Rows& rows);   ///< each normal once, by itself
  void impacts_swept(const Rows& rows);   ///< each normal any number of times
  void tangents_swept(const Rows& rows);  ///< a sweep is over
  void finished(const Rows& rows);
  std::size_t normals = 0;                      ///< so many rows, the first ones
  std::vector<Real> friction;                   ///< mu of each contact that has tangents
  const std::vector<Real>* softness = nullptr;  ///< gamma of the first rows, 1/kg; none: they hold
  std::vector<Real> guess;  ///< of each row, N s, before it is scaled: impulses as large as these were rounded off

 private:
  Real softness_of(std::size_t row) const { return softness && row < softness->size() ? (*softness)[row] : 0; }
  /// The bodies that the rows may move, once each, in the order of the world.
  void gather(const Rows& rows);
  Real energy() const;
  void balance(const char* what, const Rows& rows, std::size_t begin, std::size_t end, bool repeated = false);
  void remember(const Rows& rows);
  bool bounds_shrunk(const Rows& rows) const;

  std::vector<const Body*> bodies_;
  Real rounding_ = 0;  // relative
  Real opening_ = 0;   // J, before any impulse
  Real now_ = 0;       // J, after what was booked last
  Real returned_ = 0;  // J, by friction in this solve
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

/// Instead of SimultaneousImpacts.
struct BookedImpacts : SimultaneousImpacts {
  Ledger* ledger = nullptr;
  void sweep(auto& step) {
    ledger->normals_swept(step.rows);
    SimultaneousImpacts::sweep(step);
    ledger->impacts_swept(step.rows);
  }
};

/// Instead of ScaledWarmStart.
struct BookedScaledWarmStart : ScaledWarmStart {
  Ledger* ledger = nullptr;
  void start(auto& step) {
    ledger->guess.clear();
    for (const Row& row : step.rows) {
      const Real wanted = first_guess_[row.owner].dot(row.n);
      ledger->guess.push_back(std::clamp(wanted, row.lo, row.hi));
    }
    ScaledWarmStart::start(step);
    ledger->guess_scaled(step.rows);
  }
};

/// The last effect: nothing acts after it in any hook.
struct Bookkeeper : Effect {
  Ledger* ledger = nullptr;
  void build(StepContext& step) { ledger->open(step.rows); }
  void start(StepContext& step) { ledger->started(step.rows); }
  void finish(StepContext& step) { ledger->finished(step.rows); }
};
/// The same for a solver that relaxes.
struct RelaxingBookkeeper : Bookkeeper, Relaxes {
  void build(RelaxingContext& step) {
    ledger->softness = &step.softness;
    Bookkeeper::build(step);
  }
  void relax(RelaxingContext& step) { ledger->reopened(step.rows); }
};

/// A solver of which some effects keep books, all in one ledger.
template <template <class...> class SolverOf, class... Effects>
struct BookedSolver : SolverOf<Effects...> {
  explicit BookedSolver(Ledger& ledger) { (hand_to(static_cast<Effects&>(*this), ledger), ...); }

 private:
  template <class E>
  static void hand_to(E& effect, Ledger& ledger) {
    if constexpr (requires { effect.ledger; }) effect.ledger = &ledger;
  }
};

}  // namespace pushback
