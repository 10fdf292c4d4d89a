/// Exercise 13: a slider on a round rail. The task is chapters/13_joints/exercise/task.md.
#pragma once

#include "pushback/chapters/13_joints/exercise/asked.h"

namespace student {

using namespace pushback;

/// Called in every step, with the present bodies. Appends the two equations of the slider.
///
/// You read     rail.centre, rail.axis   in A's axes: point_of(a, rail.centre) is Q, a.orientation * rail.axis is m
///              rail.radius              R, m
///              rail.slider              in B's axes: point_of(b, rail.slider) is P
/// and append   equations.push_back({.jacobian = {.ra_n = ..., .n = ..., .rb_n = ...}, .error = C});
///              with J = [-n  -ra_n  n  rb_n], n a unit vector, C in m
inline void ask(const exercise_13::RoundRail& rail, const Body& a, const Body& b, Equations& equations) {
  // TODO C and J of the plane, C and J of the ring
  (void)rail, (void)a, (void)b, (void)equations;  // take this line out
  // TODO ends
}

inline const exercise_13::Answer answer{ask};

}  // namespace student
