/// Broad phase: which pairs of bodies are near enough to look at closely.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "pushback/common/basics/workers.h"
#include "pushback/common/collision/margin.h"

namespace pushback {

/// The smallest box along the world axes that holds a body's shape and skin; infinite in every direction for a half-space.
struct Bounds {
  Vec3 low, high;  ///< m
  bool overlaps(const Bounds& other) const {
    return (low.array() <= other.high.array()).all() && (other.low.array() <= high.array()).all();
  }
};
Bounds bounds_of(const Body& body);
/// And all that is within the margin of it.
Bounds bounds_of(const Body& body, const Margin& margin);

using BodyPair = std::pair<int, int>;  ///< indices, first < second

/// Every pair whose bounds overlap and of which at least one body can move; empty places are in none. In ascending order of (first, second).
std::vector<BodyPair> near_pairs(const std::vector<Body>& bodies, const Margin& margin = {},
                                 Workers& workers = alone());
/// The same if each body may move by up to its way, m, in any direction. Bodies that go far cost only the pairs that they may meet.
std::vector<BodyPair> near_pairs(const std::vector<Body>& bodies, const std::vector<Real>& ways);
/// Those among the bodies with the indices `which`: ascending, none twice. How many others there are costs no time.
std::vector<BodyPair> near_pairs(const std::vector<Body>& bodies, std::span<const int> which,
                                 const Margin& margin = {});

}  // namespace pushback
