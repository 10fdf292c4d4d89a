/// The motion of bodies, saved before a step that may have to be repeated.
#pragma once

#include <vector>

#include "pushback/common/world/world.h"

namespace pushback {

/// The position and the velocity of a body.
struct BodyState {
  Vec3 velocity, angular_velocity, position;
  Quat orientation;
  explicit BodyState(const Body& body);
  void restore(Body& body) const;
};

/// Fills `states` with the states of all bodies of the world.
void save_states(const World& world, std::vector<BodyState>& states);
/// Gives the first states.size() bodies their states.
void restore_states(World& world, const std::vector<BodyState>& states);

}  // namespace pushback
