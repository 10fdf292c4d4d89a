/// Other orders of the pairs for the same solver, and the fraction of its lanes that is filled.
#pragma once

#include "pushback/common/bodies/random.h"
#include "pushback/engine/substeps/wide_solver.h"

namespace pushback::wide_scenes {

/// One after the other, in the order of detection.
inline PairSets one_by_one(const std::vector<TouchingPair>& pairs, const World& /*world*/) {
  PairSets sets;
  for (const TouchingPair& pair : pairs) sets.push_back({pair});
  return sets;
}
inline PairSets from_the_last(const std::vector<TouchingPair>& pairs, const World& world) {
  PairSets sets = one_by_one(pairs, world);
  std::reverse(sets.begin(), sets.end());
  return sets;
}
/// In random order, which is the same in each step while the pairs stay the same.
inline PairSets shuffled(const std::vector<TouchingPair>& pairs, const World& world) {
  PairSets sets = one_by_one(pairs, world);
  Random(1).shuffle(sets);
  return sets;
}

inline PairSets sets_in(const World& world) {
  return colour_pairs(touching_pairs(world.contacts), world);
}
/// The fraction of the solved lanes that contain a contact.
inline Real part_filled(const PairSets& sets) {
  std::size_t contacts = 0, lanes = 0;
  for (const auto& set : sets) {
    for (std::size_t i = 0; i < set.size(); ++i) {
      contacts += set[i].count;
      if (i % lanes_per_bundle == 0) lanes += lanes_per_bundle * set[i].count;  // the first pair of eight has the most
    }
  }
  return lanes == 0 ? 1 : static_cast<Real>(contacts) / static_cast<Real>(lanes);
}

}  // namespace pushback::wide_scenes
