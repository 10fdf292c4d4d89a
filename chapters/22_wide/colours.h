/// Which pairs of bodies may be solved side by side.
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

namespace pushback {

/// The contacts of a pair of bodies: `count` that follow each other in the world's list, from `first` on.
struct PairOfBodies {
  std::size_t a, b;  ///< in the solver's list
  std::size_t first, count;
};

/// Sets of pairs, no two of a set with a movable body in common, so that nothing one of them does is read by another: greedily, in
/// the order of the pairs. A body has room for 64 colours; each pair beyond is alone in its set.
///
/// Within a set, pairs with more contacts come first: those side by side then have equally many.
inline std::vector<std::vector<PairOfBodies>> coloured(const std::vector<PairOfBodies>& pairs,
                                                       const std::vector<bool>& movable) {
  constexpr int room = 64;
  std::vector<std::uint64_t> taken(movable.size(), 0);  // of each body: a bit for each colour
  std::vector<std::vector<PairOfBodies>> sets(room);
  for (const PairOfBodies& pair : pairs) {
    std::uint64_t both = 0;
    for (const std::size_t body : {pair.a, pair.b})
      if (movable[body]) both |= taken[body];
    const int colour = std::countr_one(both);
    if (colour == room) {
      sets.push_back({pair});
      continue;
    }
    sets[std::size_t(colour)].push_back(pair);
    for (const std::size_t body : {pair.a, pair.b}) taken[body] |= std::uint64_t(1) << colour;
  }
  std::erase_if(sets, [](const auto& set) { return set.empty(); });
  for (auto& set : sets)
    std::stable_sort(set.begin(), set.end(),
                     [](const PairOfBodies& p, const PairOfBodies& q) { return p.count > q.count; });
  return sets;
}

}  // namespace pushback
