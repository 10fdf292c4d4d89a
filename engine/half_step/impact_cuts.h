/// Half steps that are cut at the times at which bodies meet.
#pragma once

#include "pushback/engine/half_step/kick_drift.h"

namespace pushback {

/// How an impact is solved (chapter 09). Sequential: pair by pair, the fastest first, until no pair approaches, or until nothing
/// bounces and a pair approaches again almost as fast as before. Simultaneous: all pairs at once.
enum class Impacts { sequential, simultaneous };

/// Pairs that are apart fly freely, without constraints:
///
///   1. finds the first time at which any of them touch, see first_touch.h
///   2. takes a half step until then, in which pairs that stay in touch are held as in chapter 24
///   3. solves an impact of the bodies that touch and approach,  J v >= -e v_n,  impulses in the cone, directly (chapter 17), with
///      a smaller e if e and friction together would add energy
///
/// and repeats this until the step is over. So bodies without joints that are apart when a step begins cannot pass through each other.
/// A pair that stays in touch is held as in chapter 24, also at other points.
///
/// The other end of a held body may come down, or the body may turn so far in a drift that it sinks in. The drift is then repeated and
/// ends when the body begins to sink.
///
/// Infinitely many bounces take a finite time. A body that leaves at speed u with an acceleration a back towards the contact returns
/// after 2 u / a, and leaves again at e u. All its bounces take
///
///   T = 2 u / (a (1 - e))
///
/// If T is at most a substep, this is the last bounce. The body leaves with no speed, so it is too low by at most
/// u^2 / (2 a) <= a h^2 (1 - e)^2 / 8. With joints a is not known in advance, and g is used instead.
///
/// Joined bodies do not fly freely. The half step itself gives their motion, because its drift uses v + h/2 a, where a includes the
/// joints. The time of touch that follows from this acceleration has an error of O(h^3). Newton's method corrects it, with a half step
/// up to that time in each round. A touch that ends within a part of a step may be missed if it is not deeper than
/// 2/81 h^3 max |x'''|. The impact is solved together with J v = 0 of the joints. A limit that is reached within a step is an impact as
/// well, but the step is not cut for it.
class ImpactCuts {
 public:
  static constexpr Real most_sinking = Real(1e-4);  ///< m, the most by which a held contact may sink in a drift

  Impacts impacts = Impacts::simultaneous;
  int most_events = 64;  ///< in a substep; its rest is then a half step in which all pairs are held

  /// Call it before each step.
  void begin() { events_ = 0, dissipated_energy_ = 0, bound_reached_ = contacts_held_ = false; }
  /// A substep of h. If it fails, returns false, and `motion.failure` gives the reason.
  bool advance(KickDrift& motion, World& world, Real h);

  // ---- of the latest step ---------------------------------------------------------------------------------------------
  int events() const { return events_; }                         ///< how often bodies met
  bool bound_reached() const { return bound_reached_; }          ///< whether `most_events` was reached
  Real dissipated_energy() const { return dissipated_energy_; }  ///< J, the kinetic energy that impacts have dissipated
  bool contacts_held() const { return contacts_held_; }          ///< whether contacts were held

 private:
  static constexpr Real touch_distance = HeldContacts::touch_distance;
  static constexpr Real resting_speed = std::numeric_limits<Real>::digits > 24
                                            ? Real(1e-6)
                                            : Real(1e-3);  // m/s; slower is no impact
  struct Sunk {                                            // a held contact that sank in the drift
    Real since;                                            // s, since it began to sink, or infinite if that is unknown
    std::ptrdiff_t known =
        -1;       // its index in the contacts before the drift, if it touched then and only its rotation makes it sink
    Real by = 0;  // m
  };
  /// The length of a part of a substep, s, or none if the part failed.
  using Length = std::optional<Real>;

  bool impact(KickDrift& motion, World& world, Real h, bool& met);
  bool bounce(KickDrift& motion, World& world, Real h, const std::vector<std::size_t>& which);
  bool strike_free(KickDrift& motion, StepContext& step);
  bool solve_free(KickDrift& motion, StepContext& step);
  void find_accelerations(const KickDrift& motion, const World& world);
  Length try_half_step(KickDrift& motion, World& world, const KickDrift::Snapshot& begin, Real within);
  Real pressing_acceleration(const World& world, const Contact& at) const;
  void hold_touching(KickDrift& motion, World& world, Real h);
  bool next_touch(KickDrift& motion, const World& world, const std::vector<Body>& bodies, Real within,
                  std::optional<Real>& touch);
  std::vector<Sunk> sunk_since(const KickDrift& motion, const World& world, const Contacts& begun, Real h) const;
  Real touch_in(const KickDrift& motion, const World& world, const Contacts& begun, Real h) const;
  bool touch_already(const Contacts& contacts) const;
  Length move_free(KickDrift& motion, World& world, Real within);
  Length move_joined(KickDrift& motion, World& world, Real within);

  std::vector<std::size_t> touching_, of_pair_;  // indices of World::contacts
  std::vector<Vec3> accelerations_, turning_;    // of each body, including the loads of contacts, m/s^2 and rad/s^2
  std::optional<BodyPair> first_;                // the pair of KickDrift::near_pairs that touches first
  WarmDirectContacts direct_ = exact_direct_contacts();
  int events_ = 0;
  Real dissipated_energy_ = 0;
  bool bound_reached_ = false, contacts_held_ = false;
};

}  // namespace pushback
