/// A half step that is cut where bodies meet.
#pragma once

#include <algorithm>

#include "pushback/engine/half_step/half_step.h"

namespace pushback {

/// Which of chapter 09's impacts: each pair by itself, the fastest first, until none approaches; or all at the same time.
enum class Impacts { sequential, simultaneous };

/// In the place of HalfStep, whose settings it has. Pairs that are apart fly freely, and are not held:
///
///   1. the first time at which any of them touch, see first_touch.h
///   2. a half step until then; pairs that stay in touch are held in it, as chapter 24 does
///   3. where bodies touch and approach, an impact:  J v >= -e v_n,  impulses inside the cone, solved directly (chapter 17); with a
///      smaller e where that and friction would give energy
///
/// and again, until the step is over. So nothing that is apart when a step begins can pass through anything else. A pair that
/// stays in touch is held as in chapter 24, also where it touches next.
///
/// A held body may come down with its other end, or turn so far in a drift that it sinks in. The drift is then repeated, and ends when the
/// sinking begins.
///
/// Bounces end. What leaves with u and is pressed back by a is there again after 2 u / a, then slower by e: infinitely many bounces take
///
///   T = 2 u / (a (1 - e))
///
/// Where T is not above a substep, that is the last one: it leaves with no speed, u^2 / (2 a) <= a h^2 (1 - e)^2 / 8 too low. With
/// joints, nobody knows a in advance, and it is taken to be g.
///
/// Joined bodies do not fly freely. The half step itself says how they move: its drift goes by v + h/2 a, with an a that joints are in.
/// The time at which bodies touch that accelerate so is off by O(h^3). Newton's method puts it right, each time with a half step up to
/// there. The impact is solved together with J v = 0 of the joints. A limit that is reached within a step is an impact as well, but the
/// step is not cut for it.
class AtImpacts : public HalfStep {
 public:
  static constexpr Real sinks = Real(1e-4);  ///< m: by no more than this does a drift let in what is held

  AtImpacts() { tolerance = std::min(tolerance, HeldContacts::touches / 4); }  // m: what joints are off is no gap

  Impacts impacts = Impacts::simultaneous;
  int most_events = 64;  ///< in a substep; what is left of it is then a half step in which all pairs are held

  Plan plan(Real dt) const override;
  void check(World& world, Real h) override;
  void solve(World& world, Real h, int sweeps) override;
  /// In the latest step: how often bodies have met.
  int events() const { return events_; }
  /// In the latest step: whether `most_events` were too few.
  bool bound_reached() const { return bound_reached_; }
  /// In the latest step, J: the kinetic energy that impacts have taken. Below 0 where Newton's rule and friction gave some, which only
  /// joined bodies are left.
  Real taken() const { return taken_; }
  /// In the latest step: whether contacts were held.
  bool held() const { return held_; }

 protected:
  void advance(World& world, Real h) override;
  void begin_contacts(World& world, Real h) override;
  void detect_contacts(World& world, Real h) override;

 private:
  bool impact(World& world, Real h);
  void strike_free(StepContext& step);
  void bounce(World& world, Real h, const std::vector<std::size_t>& which);
  void accelerate_bodies(const World& world);
  Real try_step(World& world, const Moment& begin, Real within);
  Real pressing(const World& world, const Contact& at) const;
  void hold_touching(World& world, Real h);
  void look_ahead(World& world, Real h);
  std::optional<Real> next_touch(const World& world, const std::vector<Body>& bodies, Real within);
  Real touch_in(const World& world, const Contacts& begun, Real h) const;
  struct Sunk {
    Real since;                 // s: since it began to sink; infinite if unknown
    std::ptrdiff_t known = -1;  // its place in `begun`, where it touched and the turn tells all of it
    Real by = 0;                // m
  };
  std::vector<Sunk> sunk_since(const World& world, const Contacts& begun, Real h) const;
  bool touch_already(const Contacts& contacts) const;
  Real move_free(World& world, Real within);
  Real move_joined(World& world, Real within);

  std::vector<std::size_t> touching_, of_pair_;  // places in World::contacts
  std::vector<Vec3> accelerations_, turning_;    // of each body, with what is borne, m/s^2 and rad/s^2
  std::vector<BodyPair> near_;                   // in the part that begins
  std::optional<BodyPair> first_;                // of these, who touch first
  WarmDirectContacts direct_ = exact_direct_contacts();
  bool ahead_ = false;  // whether World::contacts has what may touch in the next drift
  int events_ = 0;
  Real taken_ = 0;
  bool bound_reached_ = false, held_ = false;
};

}  // namespace pushback
