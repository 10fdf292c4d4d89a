/// Other orders of the pairs for the same solver, and the fraction of its lanes that is filled.
#pragma once

#include "pushback/common/bodies/random.h"
#include "pushback/engine/substeps/wide.h"

namespace pushback::wide_scenes {

/// One after the other, in the order of detection.
inline Sets one_by_one(const std::vector<PairOfBodies>& pairs, const World& /*world*/) {
  Sets sets;
  for (const PairOfBodies& pair : pairs) sets.push_back({pair});
  return sets;
}
inline Sets from_the_last(const std::vector<PairOfBodies>& pairs, const World& world) {
  Sets sets = one_by_one(pairs, world);
  std::reverse(sets.begin(), sets.end());
  return sets;
}
/// In random order, which is the same in each step while the pairs stay the same.
inline Sets shuffled(const std::vector<PairOfBodies>& pairs, const World& world) {
  Sets sets = one_by_one(pairs, world);
  Random(1).shuffle(sets);
  return sets;
}

inline Sets sets_in(const World& world) {
  return coloured(touching_pairs(world.contacts), world);
}
/// The fraction of the solved lanes that contain a contact.
inline Real part_filled(const Sets& sets) {
  std::size_t contacts = 0, lanes = 0;
  for (const auto& set : sets) {
    for (std::size_t i = 0; i < set.size(); ++i) {
      contacts += set[i].count;
      if (i % lanes_of_bundle == 0) lanes += lanes_of_bundle * set[i].count;  // the first pair of eight has the most
    }
  }
  return lanes == 0 ? 1 : static_cast<Real>(contacts) / static_cast<Real>(lanes);
}

}  // namespace pushback::wide_scenes
