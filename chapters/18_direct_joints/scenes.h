/// A chain that carries a heavy load.
#pragma once

#include "pushback/chapters/13_joints/ball_and_socket.h"

namespace pushback::direct_joints_scenes {

/// Links of 1 kg, joined by balls and sockets, hang straight down from the origin. A box hangs from the last link.
/// Two bars behind them mark the upper end and the correct lower end.
struct LoadedChain {
  int links = 20;
  Real load = 1000;  ///< kg, or masses of a link

  static constexpr Real length = 3;  ///< m, of all links together
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
  /// The elongation of the chain, relative to the length of its links.
  Real stretch(const World& world) const {
    return point_of(world.bodies[static_cast<std::size_t>(links)], {0, load_half, 0}).norm() / length - 1;
  }
};

}  // namespace pushback::direct_joints_scenes
