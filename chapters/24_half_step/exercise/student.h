/// Exercise 24: a step of second order. The task is chapters/24_half_step/exercise/task.md.
#pragma once

#include "pushback/chapters/24_half_step/exercise/asked.h"

namespace student {

using namespace pushback;
using exercise_24::Bob;

/// Advances a ball of 1 kg by h seconds. A rod holds the ball at the distance bob.length from the origin.
///
/// You read and change   bob.x, bob.v   the position, m, and the velocity, m/s
/// You read              bob.length     m
///                       bob.off(x)     C at the position x, the distance from the origin minus the length of the rod, m
///                       bob.rod()      J: the unit vector from the origin to the present position of the ball
///                       g              m/s^2
inline void step(Bob& bob, const Vec3& g, Real h) {
  // TODO half a kick, the impulse that keeps the length over the drift, drift, half a kick, and the impulse for J v = 0
  (void)bob, (void)g, (void)h;  // take this line out
  // TODO ends
}

inline const exercise_24::Answer answer{step};

}  // namespace student
