/// Exercise 20: islands. The task is chapters/20_only_what_is_needed/exercise/task.md.
#pragma once

#include "pushback/chapters/20_only_what_is_needed/exercise/asked.h"

namespace student {

using namespace pushback;

/// Returns for each body whether it may fall asleep.
///
/// You read   rests[i]                      whether body i has kept its place for long enough
///            world.bodies[i].movable()     whether body i can move
///            world.contacts                the pairs that touch: contact.id.body_a and .body_b are indices of bodies
///            world.joints                  the pairs that are joined: joint.a and .b are indices of bodies
inline std::vector<bool> asleep(const World& world, const std::vector<bool>& rests) {
  std::vector<bool> sleeps(world.bodies.size(), false);
  // TODO find the islands from contacts and joints, and then decide which of them fall asleep
  (void)rests;  // take this line out
  // TODO ends
  return sleeps;
}

inline const exercise_20::Answer answer{asleep};

}  // namespace student
