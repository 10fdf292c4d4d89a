/// Exercise 24: a step of second order. The task is chapters/24_half_step/exercise/task.md.
#pragma once

#include "pushback/chapters/24_half_step/exercise/asked.h"

namespace student {

using namespace pushback;
using exercise_24::Bob;

/// Moves a ball of 1 kg on a rod, which holds it at bob.length from the origin, on by h seconds.
///
/// You read and change   bob.x, bob.v   m and m/s: where it is and how it moves
/// You read              bob.length     m
///                       bob.off(x)     m, C: how far a place x is from where the rod would have it
///                       bob.rod()      J, unit: from the origin to where the ball is now
///                       g              m/s^2
inline void step(Bob& bob, const Vec3& g, Real h) {
  // TODO kick, hold the length after the drift, drift, kick, and no speed along the rod
  (void)bob, (void)g, (void)h;  // take this line out
  // TODO ends
}

inline const exercise_24::Answer answer{step};

}  // namespace student
