/// Whether what a step says it did is what it did.
#pragma once

#include <string>

#include "pushback/common/world/world.h"

namespace pushback {

/// Compares what each movable body's momentum has changed by in a step of dt with what the world reports:
///
///   m (v' - v) = h (m g + F) + sum(contact impulses) + sum(joint impulses)
///
/// Joints count whose equations are along the axes of the world, or between turns, as those of a ball and socket, a hinge or a weld. The
/// direction of any other turns within the step, so the bodies that it holds are left out. World::forces are to be empty.
class MomentumAccount {
 public:
  /// Before the step.
  explicit MomentumAccount(const World& world);
  /// What does not add up, with its number; empty where all does. `epsilon`: the rounding unit of the numbers that impulses are in.
  std::string look(const World& after, Real dt, Real epsilon = std::numeric_limits<Real>::epsilon());

 private:
  Real largest_ = 0;  // N s, of all numbers that were added up so far
  World before_;
};

}  // namespace pushback
