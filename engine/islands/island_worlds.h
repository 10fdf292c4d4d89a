/// The islands that half steps or Fast move, as separate worlds.
#pragma once

#include "pushback/engine/islands/island_world.h"
#include "pushback/engine/islands/step_classifier.h"

namespace pushback {

class IslandWorlds {
 public:
  /// Makes a world of each island that gets half steps or is a large pile. The island's joints are moved to that world, until
  /// `give_joints` moves them back. `found`: the contacts of this step.
  void divide(World& world, StepClassifier& classifier, const Contacts& found);
  void give_joints(World& world);
  /// Gives large piles their contacts of this step.
  void give_found(const World& world, StepClassifier& classifier, const Contacts& found);
  /// Writes the bodies and contacts of islands that have been moved into the whole world. `fraction`: the length of the whole world's last
  /// substep, as a fraction of the step.
  void commit(World& world, Real fraction) const;

  std::size_t size() const { return count_; }
  IslandWorld& operator[](std::size_t i) { return islands_[i]; }
  const IslandWorld& operator[](std::size_t i) const { return islands_[i]; }

 private:
  void add_bodies(const World& world, StepClassifier& classifier);
  IslandWorld* island_of(const Body& a, const Body& b, StepClassifier& classifier);

  std::vector<IslandWorld> islands_;  // those from `count_` on are kept for their allocated memory
  std::size_t count_ = 0;
  std::vector<int> place_;  // index in islands_, by the lowest body of each island
};

}  // namespace pushback
