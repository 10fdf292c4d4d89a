/// Exercise 21: contacts that are detected once. The task is chapters/21_detected_once/exercise/task.md.
#pragma once

#include "pushback/chapters/21_detected_once/exercise/asked.h"

namespace student {

using namespace pushback;
using exercise_21::Found;
using exercise_21::Moved;

// You read   found.C                    C_0, m: how far the bodies were apart when the contact was detected
//            found.n                    unit, from A to B
//            found.arm_a, found.arm_b   m, from each centre of mass to the point
//            a.way, a.turn              what A has moved since, m, and turned, rad; b likewise

// TODO the three functions: C_0 + J dX; what is apart may come nearer by as much; what is on its way is not to be stopped

/// C, m: how far the bodies of this contact are apart now, to first order in what they have turned.
inline Real separation(const Found& found, const Moved& a, const Moved& b) {
  (void)a, (void)b;  // take this line out
  return found.C;
}

/// b of the row JV + b >= 0, m/s, as a substep of h seconds begins. What overlaps is pushed out at `rate`, 1/s.
inline Real bias(Real C, Real rate, Real h) {
  (void)h;  // take this line out
  return rate * C;
}

/// The same for the relaxing pass: the substep began with `bias`, then the bodies moved, and now they are apart by C.
inline Real relaxed_bias(Real bias, Real C, Real h) {
  (void)C, (void)h;  // take this line out
  return bias;
}

// TODO ends

inline const exercise_21::Answer answer{separation, bias, relaxed_bias};

}  // namespace student
