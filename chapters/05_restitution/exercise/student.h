/// Exercise 05: the bias of a bounce. The task is chapters/05_restitution/exercise/task.md.
#pragma once

#include "pushback/chapters/05_restitution/exercise/asked.h"

namespace student {

using namespace pushback;

/// Newton's rule: two bodies separate e times as fast as they approached.
///
/// You read   step.contacts.size()          how many contacts there are; step.rows[i] is the normal row of step.contacts[i]
///            step.world.bodies_of(contact)  its bodies A and B:   const auto [a, b] = step.world.bodies_of(contact);
/// of a contact   point, m;   normal, from A to B;   restitution, e
/// of a body      position, m;   velocity_before, angular_velocity_before: as the step began
///                velocity, angular_velocity: this step's gravity is in them already
/// and set        step.rows[i].bias   b, m/s: minus the wanted separating speed; the push-out may have set it
struct Bounce : Effect {
  Real threshold = Real(0.1);  // m/s; what arrives more slowly does not bounce

  void build(StepContext& step) {
    // TODO for each normal row: the approach speed v_n of the two points that touch, and the bias by Newton's rule; of
    // two wishes, the one for more speed stays
    (void)step;  // take this line out
    // TODO ends
  }
};

inline const exercise_05::Answer answer{Bounce{}};

}  // namespace student
