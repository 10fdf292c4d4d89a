/// A heavy box on four light ones, solved without warm start.
#pragma once

#include "pushback/common/experiment/marks.h"
#include "pushback/common/world/situations.h"

namespace pushback::direct_contacts_scenes {

struct HeavyOnFour {
  Real ratio = 1000;  ///< mass of the heavy box, in masses of a light one

  static constexpr int light = 4;
  static constexpr Real sunk_at_start = Real(0.001);  ///< m, each into the one below, so that all contacts exist

  void operator()(World& world) const {
    stack(world, light);
    world.add(box(Vec3::Constant(Real(0.5)), 100 * ratio).at({0, light + Real(0.5), 0}).coloured(6));
    for (std::size_t i = 1; i < world.bodies.size(); ++i)
      world.bodies[i].position.y() -= static_cast<Real>(i) * sunk_at_start;
  }
  /// The distance by which the heavy box has sunk since the start, m.
  Real height_lost(const World& world) const {
    return light * (1 - sunk_at_start) + Real(0.5) - sunk_at_start - world.bodies.back().position.y();
  }
  /// Draws the boxes where they should be.
  static void mark(Picture& picture) {
    for (int i = 0; i <= light; ++i)
      add_outline(picture,
                  box(Vec3::Constant(Real(0.5)), 1)
                      .at({0, static_cast<Real>(i) + Real(0.5) - static_cast<Real>(i + 1) * sunk_at_start, 0}));
  }
};

}  // namespace pushback::direct_contacts_scenes
