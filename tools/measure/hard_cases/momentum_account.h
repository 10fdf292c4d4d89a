/// Checks whether the impulses that a step reports explain the motion of the bodies.
#pragma once

#include <string>

#include "pushback/common/world/world.h"

namespace pushback {

/// Compares the change of each movable body's momentum in a step of dt with the impulses that the world reports:
///
///   m (v' - v) = h (m g + F) + sum(contact impulses) + sum(joint impulses)
///
/// Joints are included if their equations are along world axes or rotational, as for a ball and socket, a hinge or a weld. The
/// directions of other equations rotate within the step, so bodies with such joints are left out. World::forces must be empty.
class MomentumAccount {
 public:
  /// Call it before the step.
  explicit MomentumAccount(const World& world);
  /// A text on the first discrepancy with its value, or empty if there is none. `epsilon`: the rounding unit of the impulses.
  std::string look(const World& after, Real dt, Real epsilon = std::numeric_limits<Real>::epsilon());

 private:
  Real largest_ = 0;  // N s, the largest of all terms added so far
  World before_;
};

}  // namespace pushback
