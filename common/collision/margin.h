/// The gap up to which two bodies count as touching.
#pragma once

#include "pushback/common/bodies/body.h"

namespace pushback {

/// Solvers that solve more often than they detect need a margin, because bodies that are apart now may touch before the next detection.
struct Margin {
  Real least = 0;  ///< m
  Real ahead = 0;  ///< s: adds the distance by which the pair may approach in this time, moving straight on

  /// If false, bodies that are apart get the normal with which they would touch in that time. If true, they get the normal between
  /// their closest features now, for solvers that detect again whenever bodies have moved.
  bool where_nearest = false;

  /// The gap, m, up to which the pair counts as touching.
  Real of(const Body& a, const Body& b) const { return least + ahead * (b.velocity - a.velocity).norm(); }
};

}  // namespace pushback
