/// Exercise 25: a step that is cut where a ball meets the ground. The task is chapters/25_moment_of_impact/exercise/task.md.
#pragma once

#include "pushback/chapters/25_moment_of_impact/exercise/asked.h"

namespace student {

using namespace pushback;
using exercise_25::Ball;

/// Advances a ball that falls and bounces by h seconds.
///
/// You read and change   ball.y, ball.v   m above the ground, 0 or more, and m/s upwards
/// You read              ball.e           its coefficient of restitution, below 1
///                       g                m/s^2, downwards
inline void step(Ball& ball, Real g, Real h) {
  // TODO until the step is over: fly to the ground, bounce, and stop the ball if it would bounce infinitely often
  (void)ball, (void)g, (void)h;  // take this line out
  // TODO ends
}

inline const exercise_25::Answer answer{step};

}  // namespace student
