#include "pushback/engine/half_step/body_state.h"

namespace pushback {

BodyState::BodyState(const Body& body)
    : velocity(body.velocity),
      angular_velocity(body.angular_velocity),
      position(body.position),
      orientation(body.orientation) {}

void BodyState::restore(Body& body) const {
  body.velocity = velocity;
  body.angular_velocity = angular_velocity;
  body.position = position;
  body.orientation = orientation;
}

void save_states(const World& world, std::vector<BodyState>& states) {
  states.clear();
  for (const Body& body : world.bodies) states.emplace_back(body);
}

void restore_states(World& world, const std::vector<BodyState>& states) {
  for (std::size_t i = 0; i < states.size(); ++i) states[i].restore(world.bodies[i]);
}

}  // namespace pushback
