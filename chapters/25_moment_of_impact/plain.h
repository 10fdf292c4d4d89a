/// The step that is cut at impacts, as plain functions for one ball above the ground.
#pragma once

#include <cmath>

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

/// Chapter 24's step: a ball that ends below the ground is placed on it and bounces at the end of the step.
inline void late_step(Ball& ball, Real g, Real h) {
  fly(ball, g, h);
  if (ball.y >= 0) return;
  ball.y = 0;
  ball.v *= -ball.e;
}

}  // namespace pushback::plain_25
