/// Whose angular momentum is kept.
#pragma once

#include <vector>

#include "pushback/chapters/20_only_what_is_needed/islands.h"

namespace pushback {

/// Of each body, whether it floats: no body of its island (chapter 20) touches, or is joined to, what nothing moves. What is immovable
/// does not float.
inline std::vector<bool> floating(const World& world) {
  std::vector<int> all(world.bodies.size());
  std::iota(all.begin(), all.end(), 0);
  Islands islands;
  islands.separate(all, all.size());
  islands.join(world.contacts, world);
  islands.join(world.joints, world);
  std::vector<bool> held(all.size(), false);  // of the island's lowest body
  const auto hold = [&](const Body& a, const Body& b) {
    if (a.movable() == b.movable()) return;
    held[std::size_t(islands.island_of((a.movable() ? a : b).index))] = true;
  };
  for (const Contact& contact : world.contacts) hold(world.bodies_of(contact).first, world.bodies_of(contact).second);
  for (const Joint& joint : world.joints) hold(world.body(joint.a), world.body(joint.b));
  std::vector<bool> floats(all.size());
  for (const int i : all) floats[std::size_t(i)] = world.body(i).movable() && !held[std::size_t(islands.island_of(i))];
  return floats;
}

}  // namespace pushback
