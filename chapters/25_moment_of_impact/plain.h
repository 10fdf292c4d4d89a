/// The cut step as a plain loop, for one ball above the ground.
#pragma once

#include <cmath>

#include "pushback/common/basics/types.h"

namespace pushback::plain_25 {

struct Ball {
  Real y, v;  // m above the ground, m/s upwards
  Real e;     // of its bounces, below 1
};

/// The time at which y + v t - g t^2 / 2 = 0.
inline Real time_to_ground(const Ball& ball, Real g) {
  return (ball.v + std::sqrt(ball.v * ball.v + 2 * g * ball.y)) / g;
}
inline void fly(Ball& ball, Real g, Real t) {
  ball.y += t * (ball.v - g * t / 2);
  ball.v -= g * t;
}

/// Flies until it meets the ground, bounces, and flies on.
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

/// Chapter 24's: what comes below the ground is at it when the step ends, and bounces then.
inline void late_step(Ball& ball, Real g, Real h) {
  fly(ball, g, h);
  if (ball.y >= 0) return;
  ball.y = 0;
  ball.v *= -ball.e;
}

}  // namespace pushback::plain_25
