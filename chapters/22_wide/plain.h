/// The greedy colouring, as a plain function.
#pragma once

#include <cstddef>
#include <vector>

namespace pushback::plain_22 {

/// Two bodies that touch, by their indices.
struct Pair {
  std::size_t a, b;
  bool operator==(const Pair&) const = default;
};
using Set = std::vector<Pair>;

/// Each pair, in the order of the list, goes into the first set in which neither of its movable bodies occurs. `movable` has an entry
/// for each body.
inline std::vector<Set> coloured(const std::vector<Pair>& pairs, const std::vector<bool>& movable) {
  std::vector<Set> sets;
  std::vector<std::vector<bool>> occurs;  // in each set, each movable body
  for (const Pair& pair : pairs) {
    std::size_t set = 0;
    while (set < sets.size() && (occurs[set][pair.a] || occurs[set][pair.b])) ++set;
    if (set == sets.size()) {
      sets.emplace_back();
      occurs.emplace_back(movable.size(), false);
    }
    sets[set].push_back(pair);
    occurs[set][pair.a] = movable[pair.a];
    occurs[set][pair.b] = movable[pair.b];
  }
  return sets;
}

}  // namespace pushback::plain_22
