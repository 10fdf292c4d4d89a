/// A hand in the picture: which body is under it, and the spring by which it pulls.
#pragma once

#include <optional>

#include "pushback/common/world/query.h"

namespace pushback {

/// From a point of a body to where the hand is.
struct Grab {
  std::size_t body = 0;
  Vec3 on_body;  ///< m, body axes from its centre of mass
  Vec3 hand;     ///< m, world axes
};

/// What the ray meets first, if that can move, and the point where it does so.
std::optional<Grab> grab(const World& world, const Ray& ray);

/// A damped spring that is as stiff for a heavy body as for a light one: alone, each follows the hand with the same
/// motion. `dt`: s, of the steps in which it acts; with long ones it is softer, so that it stays stable.
Force pull_of(const Grab& grab, Real dt);

}  // namespace pushback
