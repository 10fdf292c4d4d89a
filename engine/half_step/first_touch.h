/// Finds the time at which two bodies that move freely first touch.
#pragma once

#include <optional>
#include <vector>

#include "pushback/common/bodies/body.h"

namespace pushback {

/// A body with its future motion if it touches nothing, which is a half step of t seconds from its present state.
class Flight {
 public:
  /// `linear`, `angular`: the body's accelerations, m/s^2 and rad/s^2, world axes. `within`: the latest time of any query, s.
  Flight(const Body& body, const Vec3& linear, const Vec3& angular, Real within);
  /// The state after t seconds, without I^-1.
  const Body& at(Real t);

  /// A corner of the body's core relative to its position, with its velocity and acceleration, in world axes.
  struct Corner {
    Vec3 arm, velocity, acceleration;
  };
  /// All corners, at the time of the latest call of `at`. Their speeds have an error of at most `slack`, m/s.
  const std::vector<Corner>& look();
  /// The number of calls of `look`.
  int looks() const { return looks_; }
  Real slack() const { return bend_ * little_ / 2; }
  /// An upper bound of the acceleration of a corner by the rotation of the body, m/s^2.
  Real bend() const { return bend_; }
  /// An upper bound of the rate of change of that acceleration, m/s^3.
  Real jerk() const { return jerk_; }
  /// The body's velocity (m/s) and acceleration (m/s^2) at the time of the latest call of `at`.
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

/// The time of the first touch, s from now, or none if the bodies do not touch within `within` s. At that time their distance is at
/// most `touching` (m), and it has not been smaller before. If bodies touch now and separate, the time of their next touch is found.
///
/// Two convex bodies are apart as long as their projections on some line are. Let n be the direction along which they are d apart.
/// The distance between corner p of A and corner q of B along n is at least
///
///   d_pq(t + s) >= d_pq + c s + (a - j s / 3) s^2 / 2     c, a:  relative velocity and acceleration along n,  j:  bound of the jerk
///
/// and at least the same expression with the acceleration of the centres minus the bound of the corners' acceleration by rotation.
/// So the bodies cannot touch before the first root of any of these. The search advances to this root and repeats (conservative
/// advancement). The line may also rotate as the bodies do, with velocities and accelerations relative to it. The search takes the
/// longest advance of a few such lines, so bodies that slide over each other take few rounds. For balls, this is Newton's method,
/// from the side on which it never oversteps.
///   Mirtich, Impulse-based Dynamic Simulation of Rigid Body Systems, PhD thesis, Berkeley 1996, 2.3, with speeds only.
/// After 100 rounds, the search ends at a time before which the bodies do not touch.
std::optional<Real> first_touch(Flight& a, Flight& b, Real within, Real touching);

/// The first s > 0 with  d + c s + a s^2 / 2 = 0,  d >= 0, or infinity if there is none.
Real first_root(Real d, Real c, Real a);

}  // namespace pushback
