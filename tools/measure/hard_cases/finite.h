/// Whether a world still is one.
#pragma once

#include "pushback/common/world/world.h"

namespace pushback {

inline bool finite(const World& world) {
  for (const Body& body : world.bodies) {
    if (!body.position.allFinite() || !body.orientation.coeffs().allFinite()) return false;
    if (!body.velocity.allFinite() || !body.angular_velocity.allFinite()) return false;
  }
  for (const Contact& contact : world.contacts) {
    if (!contact.impulse.allFinite()) return false;
  }
  return true;
}

}  // namespace pushback
