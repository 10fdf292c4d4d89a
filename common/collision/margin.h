/// From how far apart two bodies count as touching.
#pragma once

#include "pushback/common/bodies/body.h"

namespace pushback {

/// For who detects contacts less often than it solves them: what is apart now may touch before the next detection.
struct Margin {
  Real least = 0;  ///< m
  Real ahead = 0;  ///< s: and by as much as the pair may come nearer in this time, moving straight on

  /// What is apart has the normal with which it would touch in that time. Or, for those who detect again as often as bodies have moved,
  /// the one between what is nearest now.
  bool where_nearest = false;

  Real of(const Body& a, const Body& b) const { return least + ahead * (b.velocity - a.velocity).norm(); }
};

}  // namespace pushback
