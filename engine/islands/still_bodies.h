/// A search tree of bodies that stay in place. It finds the bodies near a moving body without testing each.
#pragma once

#include <span>
#include <vector>

#include "pushback/common/collision/broad_phase.h"

namespace pushback {

/// A tree of bounds. The bounds of a fork contain the bounds of both branches. If they are not near, its branches are skipped.
class StillBodies {
 public:
  StillBodies() = default;
  /// Arranges the bodies with the indices `which`, none twice, at their present positions. If one moves later, call this again.
  /// Half-spaces are excluded, because their infinite bounds are near everything. near_pairs() checks planes itself.
  StillBodies(const std::vector<Body>& bodies, std::span<const int> which);

  /// Appends the index of every body whose bounds overlap these, in ascending order, after the present content of `found`.
  void near(const Bounds& bounds, std::vector<int>& found) const;

 private:
  struct Node {
    Bounds bounds;
    int body = -1;  ///< index; -1 at a fork
    int after = 0;  ///< the node that follows this one and all those below it
  };
  void arrange(const std::vector<Body>& bodies, std::span<int> which, std::size_t here);

  std::vector<Node> nodes_;  ///< each fork is followed by its lower branch, then by its upper one
};

}  // namespace pushback
