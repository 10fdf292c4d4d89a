/// The broad phase finds the pairs of bodies that are near enough for the narrow phase.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "pushback/common/basics/workers.h"
#include "pushback/common/collision/margin.h"

namespace pushback {

/// The smallest box along the world axes that contains a body's shape and skin. Infinite in every direction for a half-space.
struct Bounds {
  Vec3 low, high;  ///< m
  bool overlaps(const Bounds& other) const {
    return (low.array() <= other.high.array()).all() && (other.low.array() <= high.array()).all();
  }
};
Bounds bounds_of(const Body& body);
/// The same, enlarged by the margin, which is `least` on all sides plus the displacement of the body in the time `ahead`.
Bounds bounds_of(const Body& body, const Margin& margin);

using BodyPair = std::pair<int, int>;  ///< indices, first < second

/// All pairs with at least one movable body whose bounds, enlarged by the margin, overlap, in ascending order of (first, second).
/// Removed bodies are in no pair.
std::vector<BodyPair> near_pairs(const std::vector<Body>& bodies, const Margin& margin = {},
                                 Workers& workers = alone());
/// The same if each body may move by up to `ways[index]`, m, in any direction. A body that may move far adds pairs only with the
/// bodies that it may meet.
std::vector<BodyPair> near_pairs(const std::vector<Body>& bodies, const std::vector<Real>& ways);
/// The same for the bodies with the indices `which`, in ascending order without repetition. Other bodies take no time.
std::vector<BodyPair> near_pairs(const std::vector<Body>& bodies, std::span<const int> which,
                                 const Margin& margin = {});

}  // namespace pushback
