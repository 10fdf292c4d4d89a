/// The step that is cut at impacts, as plain functions for one ball above the ground, and the search for the impact of a rod.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "pushback/common/basics/types.h"

namespace pushback::plain_25 {

struct Ball {
  Real y, v;  // m above the ground, m/s upwards
  Real e;     // coefficient of restitution, below 1
};

/// The time at which y + v t - g t^2 / 2 = 0, s.
inline Real time_to_ground(const Ball& ball, Real g) {
  return (ball.v + std::sqrt(ball.v * ball.v + 2 * g * ball.y)) / g;
}
inline void fly(Ball& ball, Real g, Real t) {
  ball.y += t * (ball.v - g * t / 2);
  ball.v -= g * t;
}

/// The ball flies until it meets the ground, bounces and flies on.
inline void cut_step(Ball& ball, Real g, Real h) {
  Real left = h;
  for (Real t; (t = time_to_ground(ball, g)) <= left; left -= t) {
    fly(ball, g, t);
    ball.y = 0;
    ball.v *= -ball.e;
    if (2 * ball.v <= h * g * (1 - ball.e)) {  // infinitely many bounces within h
      ball.v = 0;
      return;
    }
  }
  fly(ball, g, left);
}

/// Chapter 24's step, in which a ball that ends below the ground is placed on it and bounces at the end of the step.
inline void late_step(Ball& ball, Real g, Real h) {
  fly(ball, g, h);
  if (ball.y >= 0) return;
  ball.y = 0;
  ball.v *= -ball.e;
}

/// A thin rod that turns in a vertical plane while it falls.
struct Rod {
  Real y, v;         // of its middle: m above the ground, m/s upwards
  Real angle, spin;  // rad from the horizontal, rad/s
  Real half;         // of its length, m
};

/// The gap between the lower end and the ground, m.
inline Real gap(const Rod& rod) {
  return rod.y - rod.half * std::abs(std::sin(rod.angle));
}

inline void fly(Rod& rod, Real g, Real t) {
  rod.y += t * (rod.v - g * t / 2);
  rod.v -= g * t;
  rod.angle += t * rod.spin;
}

/// An upper bound of the falling speed of all points of the rod within the next `left` seconds, m/s.
inline Real fastest_fall(const Rod& rod, Real g, Real left) {
  return std::max(g * left - rod.v, Real(0)) + rod.half * std::abs(rod.spin);
}

/// The time of impact by conservative advancement, s. The gap is then at most `touching` (m, above rounding), and the rod has not
/// touched the ground before. Empty if the gap stays larger for `within` seconds.
///   Mirtich, Impulse-based Dynamic Simulation of Rigid Body Systems, PhD thesis, Berkeley 1996, 2.3.
inline std::optional<Real> time_of_impact(Rod rod, Real g, Real within, Real touching) {
  for (Real t = 0;;) {
    const Real left = within - t, fastest = fastest_fall(rod, g, left);
    if (gap(rod) <= touching) return t;
    if (gap(rod) > fastest * left) return {};
    const Real safe = gap(rod) / fastest;  // no point can close the gap sooner
    fly(rod, g, safe);
    t += safe;
  }
}

}  // namespace pushback::plain_25
