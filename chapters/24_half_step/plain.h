/// The step as plain functions for one ball on a rod, with chapter 11's step and two wrong variants.
#pragma once

#include "pushback/common/basics/types.h"

namespace pushback::plain_24 {

/// 1 kg on a massless rod from the origin: |x| = length.
struct Bob {
  Vec3 x, v;    // m, m/s
  Real length;  // m

  Real off(const Vec3& at) const { return at.norm() - length; }  // C
  Vec3 rod() const { return x.normalized(); }                    // J
  void project() { v -= v.dot(rod()) * rod(); }                  // J v = 0
};

/// Newton's method with impulses along `j`, so that the rod has its length after the move by h v.
inline void hold(Bob& bob, const Vec3& j, Real h) {
  for (int round = 0; round < 20; ++round) bob.v -= bob.off(bob.x + h * bob.v) / h * j;
}

/// Kick, drift, kick.
inline void half_step(Bob& bob, const Vec3& g, Real h) {
  bob.v += h / 2 * g;
  hold(bob, bob.rod(), h);
  bob.x += h * bob.v;
  bob.v += h / 2 * g;
  bob.project();
}

/// Chapter 11's order, which has the whole kick first, then the solve for v, then x += h v. Its drift uses a velocity h/2 ahead.
inline void whole_step(Bob& bob, const Vec3& g, Real h) {
  bob.v += h * g;
  bob.project();
  bob.x += h * bob.v;
  bob.x *= bob.length / bob.x.norm();
}

/// The first wrong variant moves the ball by the average of the velocities before and after, but solves the constraint for only
/// one of them.
inline void average_step(Bob& bob, const Vec3& g, Real h) {
  const Vec3 before = bob.v;
  bob.v += h * g;
  bob.project();
  bob.x += h * (before + bob.v) / 2;
  bob.x *= bob.length / bob.x.norm();
  bob.project();
}

/// The second wrong variant is kick, drift, kick, but the impulse that keeps the length acts along the rod after a free drift.
inline void new_rod_step(Bob& bob, const Vec3& g, Real h) {
  bob.v += h / 2 * g;
  const Vec3 free = bob.x + h * bob.v;
  bob.v -= bob.off(free) / h * free.normalized();
  bob.x += h * bob.v;
  bob.v += h / 2 * g;
  bob.project();
}

}  // namespace pushback::plain_24
