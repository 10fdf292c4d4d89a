/// Bodies of islands that touch nothing immovable.
#pragma once

#include <vector>

#include "pushback/common/world/islands.h"
#include "pushback/engine/substeps/pair_colouring.h"

namespace pushback {

/// For each body, whether it floats. A floating body is movable, and its island (chapter 20) neither touches an immovable body
/// nor is joined to one. The angular momentum of such an island must be conserved. `pairs`: all pairs that touch.
inline std::vector<bool> floating_bodies(const std::vector<TouchingPair>& pairs, const World& world) {
  std::vector<int> all(world.bodies.size());
  std::iota(all.begin(), all.end(), 0);
  Islands islands;
  islands.separate(all, all.size());
  std::vector<bool> held(all.size(), false);
  const auto meet = [&](const Body& a, const Body& b) {
    if (a.movable() && b.movable()) islands.join(a.index, b.index);
    else if (a.movable() || b.movable()) held[std::size_t((a.movable() ? a : b).index)] = true;
  };
  for (const TouchingPair& pair : pairs) meet(world.bodies[pair.a], world.bodies[pair.b]);
  for (const Joint& joint : world.joints) meet(world.body(joint.a), world.body(joint.b));
  std::vector<bool> held_island(all.size(), false);  // of the island's lowest body
  for (const int i : all)
    if (held[std::size_t(i)]) held_island[std::size_t(islands.island_of(i))] = true;
  std::vector<bool> floats(all.size());
  for (const int i : all)
    floats[std::size_t(i)] = world.body(i).movable() && !held_island[std::size_t(islands.island_of(i))];
  return floats;
}

}  // namespace pushback
