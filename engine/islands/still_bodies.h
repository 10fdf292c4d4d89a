/// Bodies that stay where they are, arranged once: those near a moving one are found without asking them all.
#pragma once

#include <span>
#include <vector>

#include "pushback/common/collision/broad_phase.h"

namespace pushback {

/// A tree: the bounds of a fork hold those of both its branches. Where they are not near, nothing below is asked.
class StillBodies {
 public:
  StillBodies() = default;
  /// Those with the indices `which`, none twice, as they are now: what moves later has to be arranged anew.
  /// No half-spaces: their bounds are infinite, so near everything. near_pairs() asks about planes themselves.
  StillBodies(const std::vector<Body>& bodies, std::span<const int> which);

  /// Appends the index of every one whose bounds overlap these, in ascending order, after whatever `found` holds.
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
