/// A stack of twenty, solved without warm start.
#pragma once

#include "pushback/common/experiment/marks.h"
#include "pushback/common/world/situations.h"

namespace pushback::whole_problem_scenes {

/// A gate around the stack shows where it should stand, and its height.
struct StackInGate {
  int boxes = 20;

  static constexpr Real sunk_at_start = Real(0.001);  ///< m, each into the one below, so that all contacts exist

  void operator()(World& world) const {
    const Real height = static_cast<Real>(boxes) + Real(0.16), thin = Real(0.05);
    for (const int side : {-1, 1})
      world.add(box({thin, height / 2, thin}, 1).fixed().at({static_cast<Real>(side), height / 2, 0}).coloured(6));
    world.add(box({1 + thin, thin, thin}, 1).fixed().at({0, height + thin, 0}).coloured(6));
    const std::size_t first = world.bodies.size() + 1;  // after the ground
    stack(world, boxes);
    for (std::size_t i = first; i < world.bodies.size(); ++i)
      world.bodies[i].position.y() -= static_cast<Real>(i - first + 1) * sunk_at_start;
  }
  /// The distance by which the top box has sunk since the start, m.
  Real height_lost_by_top(const World& world) const {
    return static_cast<Real>(boxes) * (1 - sunk_at_start) - Real(0.5) - world.bodies.back().position.y();
  }
  /// Draws the front faces of the upper boxes where they should be.
  void mark(Picture& picture) const {
    constexpr Real half = Real(0.5);
    for (int i = std::max(0, boxes - 5); i < boxes; ++i) {
      const Real low = static_cast<Real>(i) - static_cast<Real>(i + 1) * sunk_at_start;
      add_line(
          picture,
          {{-half, low, half}, {half, low, half}, {half, low + 1, half}, {-half, low + 1, half}, {-half, low, half}});
    }
  }
};

}  // namespace pushback::whole_problem_scenes
