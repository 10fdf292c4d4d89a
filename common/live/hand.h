/// A hand in the picture that pulls the body under it by a spring.
#pragma once

#include <optional>

#include "pushback/common/world/query.h"

namespace pushback {

/// The grabbed point of a body, and the position of the hand.
struct Grab {
  std::size_t body = 0;
  Vec3 on_body;  ///< m, body axes from its centre of mass
  Vec3 hand;     ///< m, world axes
};

/// The first body that the ray hits, and the point of the hit, or none if there is no body or it is not movable.
std::optional<Grab> grab(const World& world, const Ray& ray);

/// A damped spring whose stiffness is proportional to the body's mass, so that heavy and light bodies follow the hand with the same
/// motion. `dt`: s, of the steps in which it acts. The spring is softer for long steps, so that it stays stable.
Force pull_of(const Grab& grab, Real dt);

}  // namespace pushback
