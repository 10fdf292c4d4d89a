/// When two bodies that move freely first touch.
#pragma once

#include <optional>
#include <vector>

#include "pushback/common/bodies/body.h"

namespace pushback {

/// A body with its future motion if it touches nothing, which is a half step of t seconds from its present state.
class Flight {
 public:
  /// `linear`, `angular`: its accelerations, m/s^2 and rad/s^2, world axes. Queries are for at most `within` s.
  Flight(const Body& body, const Vec3& linear, const Vec3& angular, Real within);
  /// The state after t seconds, without I^-1.
  const Body& at(Real t);

  /// A corner of its core, from the body's position, with its velocity and acceleration. World axes.
  struct Corner {
    Vec3 arm, velocity, acceleration;
  };
  /// All corners, at the time of the latest call of `at`. The speeds are off by no more than `slack`, m/s.
  const std::vector<Corner>& look();
  /// How often that was done.
  int looks() const { return looks_; }
  Real slack() const { return bend_ * little_ / 2; }
  /// m/s^2, the most by which a corner curves away from its straight way, as the body turns.
  Real bend() const { return bend_; }
  /// m/s^3, the most by which its acceleration changes.
  Real jerk() const { return jerk_; }
  /// Of the body, at the time of the latest call of `at`. m/s and m/s^2.
  Vec3 velocity() const { return begin_.velocity + time_ * linear_; }
  const Vec3& acceleration() const { return linear_; }

 private:
  Body turned_after(Real t) const;

  Body begin_, moved_;
  Vec3 linear_, angular_;
  std::vector<Vec3> core_;  // body axes, m
  std::vector<Corner> seen_;
  Real time_ = 0, little_ = 0, bend_ = 0, jerk_ = 0;
  bool turns_ = false;
  int looks_ = 0;
};

/// s from now, or nothing if they do not touch within `within` s. Then they are apart by no more than `touching` (m), and have
/// not been nearer before. Bodies that touch now and separate are found when they return.
///
/// Two convex bodies are apart as long as their shadows on some line are. Take the n along which they are d apart: corner q of B and
/// corner p of A come nearer along it by no more than
///
///   d_pq(t + s) >= d_pq + c s + (a - j s / 3) s^2 / 2     c, a: their velocity and acceleration along n now,  j: the most jerk
///
/// and no more than with the acceleration of the bodies and the most that turns may bend. So nothing can touch until the first root of
/// any of these. Advance to it, and repeat (conservative advancement). The line may also turn as the bodies do, with v and a as seen
/// from it. The longest advance of a few such lines counts, so bodies that slide over each other take few rounds. For balls, this is
/// Newton's method, from the side on which it never oversteps.
///   Mirtich, Impulse-based Dynamic Simulation of Rigid Body Systems, PhD thesis, Berkeley 1996, 2.3, with speeds only.
/// After 100 rounds, the search ends at a time until which nothing has touched.
std::optional<Real> first_touch(Flight& a, Flight& b, Real within, Real touching);

/// The first s > 0 with  d + c s + a s^2 / 2 = 0,  d >= 0, or infinity if there is none.
Real first_root(Real d, Real c, Real a);

}  // namespace pushback
