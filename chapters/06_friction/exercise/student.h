/// Exercise 06: a conveyor belt, and rolling resistance. The task is chapters/06_friction/exercise/task.md.
#pragma once

#include "pushback/chapters/06_friction/exercise/asked.h"

namespace student {

using namespace pushback;

/// Called for each of the two tangents t of a contact, in each sweep, after the normals.
///
/// You read   normal.impulse      Σλn of this contact, N s
///            surfaces.mu, .lever (m), .belt_a, .belt_b (m/s, world axes)
/// You solve  slip                the row along t:  speed() is (v_B - v_A) · t at the contact point, of the bodies, m/s
///            roll                the row about t:  speed() is (w_B - w_A) · t, rad/s, and its impulses are in N m s
/// each with  n                   t, of slip only
///            effective_mass      1 / K
///            impulse             Σλ of this step
///            reach(total)        brings Σλ to `total`, but no further than lo and hi
inline void rub(const Row& normal, Row& slip, Row& roll, const exercise_06::Surfaces& surfaces) {
  // TODO friction against the slip of the surfaces including belts, then rolling resistance against the rotation
  (void)normal, (void)slip, (void)roll, (void)surfaces;  // take this line out
  // TODO ends
}

inline const exercise_06::Answer answer{rub};

}  // namespace student
