/// The distribution of bundles over threads, and workers that run the parts in another order.
#pragma once

#include "pushback/common/world/measure.h"
#include "pushback/engine/substeps/wide_solver.h"

namespace pushback::threads_scenes {

/// The number of bundles of a set.
inline std::size_t bundles_of(const std::vector<TouchingPair>& set) {
  return (set.size() + lanes_per_bundle - 1) / lanes_per_bundle;
}
/// The index of the thread that solves the bundle, as Workers divides them.
inline std::size_t thread_of(std::size_t bundle, std::size_t bundles, std::size_t threads) {
  return ((bundle + 1) * threads - 1) / bundles;
}
/// The largest possible speedup of a pass: all bundles, divided by the sum over the sets of the bundles of the busiest thread.
inline Real at_best(const PairSets& sets, std::size_t threads) {
  std::size_t all = 0, busiest = 0;
  for (const auto& set : sets) {
    all += bundles_of(set);
    busiest += (bundles_of(set) + threads - 1) / threads;
  }
  return busiest == 0 ? 1 : static_cast<Real>(all) / static_cast<Real>(busiest);
}

/// The mistake to avoid is a single set, as if any two pairs could be solved side by side.
inline PairSets all_in_one(const std::vector<TouchingPair>& pairs, const World& /*world*/) {
  return {pairs};
}

/// Runs the parts one after the other on one thread, from the first or from the last. Independent parts give the same result.
class OneAfterTheOther : public Workers {
 public:
  OneAfterTheOther(std::size_t parts, bool from_the_last) : Workers(parts, true), from_the_last_(from_the_last) {}

 private:
  void share(std::size_t count, const std::function<void(std::size_t)>& act) override {
    for (std::size_t k = 0; k < count; ++k) act(from_the_last_ ? count - 1 - k : k);
  }
  bool from_the_last_;
};

/// The number of bodies whose position or velocity differs from the other world in any bit.
inline Real elsewhere(const World& world, const World& other) {
  Real count = 0;
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    const Body &a = world.bodies[i], &b = other.bodies[i];
    if (a.position != b.position || a.orientation.coeffs() != b.orientation.coeffs() || a.velocity != b.velocity ||
        a.angular_velocity != b.angular_velocity)
      ++count;
  }
  return count;
}

}  // namespace pushback::threads_scenes
