/// Graph colouring finds the pairs of bodies that can be solved at the same time.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

#include "pushback/common/world/world.h"

namespace pushback {

/// Two bodies that touch. Their `count` contacts are consecutive in World::contacts, from `first` on.
struct TouchingPair {
  std::size_t a, b;  ///< their indices
  std::size_t first, count;
};
/// Sets are solved one after the other, the pairs of a set at the same time.
using PairSets = std::vector<std::vector<TouchingPair>>;

/// All pairs, in the order of the contacts.
inline std::vector<TouchingPair> touching_pairs(const Contacts& contacts) {
  std::vector<TouchingPair> pairs;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const auto& [a, b, feature] = contacts[i].id;
    if (pairs.empty() || pairs.back().a != a || pairs.back().b != b) pairs.push_back({a, b, i, 0});
    ++pairs.back().count;
  }
  return pairs;
}

/// Greedy colouring, in the order of the pairs. No two pairs of a set have a movable body in common, so no pair reads data that
/// another one writes. There are 64 colours. Each further pair gets its own set.
///
/// Within a set, pairs with more contacts come first, so that the pairs of a bundle have nearly the same number.
inline PairSets colour_pairs(const std::vector<TouchingPair>& pairs, const World& world) {
  constexpr int room = 64;
  std::vector<std::uint64_t> taken(world.bodies.size(), 0);  // of each body: a bit for each colour
  const auto movable = [&](std::size_t body) { return world.bodies[body].movable(); };
  PairSets sets(room);
  for (const TouchingPair& pair : pairs) {
    std::uint64_t both = 0;
    for (const std::size_t body : {pair.a, pair.b})
      if (movable(body)) both |= taken[body];
    const int colour = std::countr_one(both);
    if (colour == room) {
      sets.push_back({pair});
      continue;
    }
    sets[static_cast<std::size_t>(colour)].push_back(pair);
    for (const std::size_t body : {pair.a, pair.b}) taken[body] |= std::uint64_t(1) << colour;
  }
  std::erase_if(sets, [](const auto& set) { return set.empty(); });
  for (auto& set : sets)
    std::stable_sort(set.begin(), set.end(),
                     [](const TouchingPair& p, const TouchingPair& q) { return p.count > q.count; });
  return sets;
}

}  // namespace pushback
