/// A stack of twenty, whose sweeps begin from nothing; a chain that carries a heavy load.
#pragma once

#include "pushback/chapters/13_joints/ball_and_socket.h"
#include "pushback/common/world/situations.h"

namespace pushback {

/// A gate around it shows where it should stand, and how high.
struct StackInGate {
  int boxes = 20;

  static constexpr Real sunk_at_start = Real(0.001);  ///< m, each into the one below, so that all contacts are there

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
  /// m, from where it began.
  Real height_lost_by_top(const World& world) const {
    return static_cast<Real>(boxes) * (1 - sunk_at_start) - Real(0.5) - world.bodies.back().position.y();
  }
};

/// Links of 1 kg, ball and socket between them, that hang straight down from the origin; at the last one a box.
/// Behind it two bars: from where, and down to where it should hang.
struct LoadedChain {
  int links = 20;
  Real load = 1000;  ///< kg, or masses of a link

  static constexpr Real length = 3;  ///< m, however many links
  static constexpr Real load_half = Real(0.4);

  void operator()(World& world) const {
    const Real of_link = length / static_cast<Real>(links), radius = std::min(Real(0.05), of_link / 4);
    Vec3 end = Vec3::Zero();
    int above = the_world;
    for (int i = 0; i <= links; ++i) {
      const int here =
          i == links
              ? world.add(box(Vec3::Constant(load_half), load).at(end - Vec3(0, load_half, 0)).coloured(2))
              : world.add(capsule(radius, of_link / 2 - radius, 1).at(end - Vec3(0, of_link / 2, 0)).coloured(i % 2));
      world.joints.push_back(ball_and_socket(world, above, here, end));
      above = here;
      if (i < links) end.y() -= of_link;
    }
    for (const Real y : {Real(0), end.y() - 2 * load_half})
      world.add(box({Real(1.2), Real(0.04), Real(0.04)}, 1).fixed().at({0, y, -Real(0.6)}).coloured(6));
  }
  /// By how much it is longer than its links, of 1.
  Real stretch(const World& world) const {
    return point_of(world.bodies[static_cast<std::size_t>(links)], {0, load_half, 0}).norm() / length - 1;
  }
};

}  // namespace pushback
