/// Exercise 07: a memory for steps of changing length, and for bodies that are put elsewhere.
/// The task is chapters/07_warm_start/exercise/task.md.
#pragma once

#include "pushback/chapters/07_warm_start/exercise/asked.h"

namespace student {

using namespace pushback;
using namespace pushback::exercise_07;

/// Memory is a std::vector<Remembered>. For each point you may store
///   id        its identity (body_a, body_b, feature). Compare ids by ==
///   impulse   N s, world axes. A Contact has it under the same name once its step is solved
///   dt, age   s: see the task
/// std::erase_if(memory, [&](const Remembered& one) { return ...; }) removes the points for which that is true.

// TODO guess: the same force, for this step. keep: new impulses in, old ones out. put_elsewhere: remove the body's points

/// Called before a step of dt. Returns the initial impulse of this point, which is zero for an unknown point.
inline Vec3 guess(const Memory& memory, const ContactId& id, Real dt) {
  (void)memory, (void)id, (void)dt;  // take this line out
  return Vec3::Zero();
}
/// Called after a step of dt. `contacts` are all contacts of that step.
inline void keep(Memory& memory, const Contacts& contacts, Real dt) {
  (void)memory, (void)contacts, (void)dt;  // take this line out
}
/// Called between two steps, when the body with this index has been moved elsewhere.
inline void put_elsewhere(Memory& memory, std::uint32_t body) {
  (void)memory, (void)body;  // take this line out
}
// TODO ends

inline const Answer answer{guess, keep, put_elsewhere};

}  // namespace student
