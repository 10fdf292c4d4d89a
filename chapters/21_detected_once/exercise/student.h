/// Exercise 21: contacts that are detected once. The task is chapters/21_detected_once/exercise/task.md.
#pragma once

#include "pushback/chapters/21_detected_once/exercise/asked.h"

namespace student {

using namespace pushback;
using exercise_21::Found;
using exercise_21::Moved;

// You read   found.C                    C_0, the distance between the bodies when the contact was detected, m
//            found.n                    unit, from A to B
//            found.arm_a, found.arm_b   m, from each centre of mass to the point
//            a.way, a.turn              the displacement of A since then, m, and its rotation, rad, likewise for b

// TODO the three functions: C_0 + J dX; a gap may close within the substep; a body that approaches is not stopped early

/// C, the present distance between the bodies of this contact, to first order in their rotations, m.
inline Real separation(const Found& found, const Moved& a, const Moved& b) {
  (void)a, (void)b;  // take this line out
  return found.C;
}

/// b of the row JV + b >= 0 at the beginning of a substep of h seconds, m/s. An overlap is pushed out at `rate`, 1/s.
inline Real bias(Real C, Real rate, Real h) {
  (void)h;  // take this line out
  return rate * C;
}

/// The same for the relaxing pass. The substep began with `bias`, then the bodies moved, and now their distance is C.
inline Real relaxed_bias(Real bias, Real C, Real h) {
  (void)C, (void)h;  // take this line out
  return bias;
}

// TODO ends

inline const exercise_21::Answer answer{separation, bias, relaxed_bias};

}  // namespace student
