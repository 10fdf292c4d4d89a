/// A weight on a chain. Larger scenes are in structures.h.
#pragma once

#include "pushback/chapters/13_joints/ball_and_socket.h"

namespace pushback::joints_under_load_scenes {

inline constexpr Real link_length = Real(0.3);  // m
inline constexpr Real weight_half = Real(0.4);  // m

/// Links of 1 kg, joined by balls and sockets, hang straight down from the world. A weight hangs from the last link.
struct ChainWithWeight {
  int links = 10;
  Real mass_ratio = 100;  ///< mass of the weight, in masses of a link

  void operator()(World& world) const {
    Vec3 end = Vec3::Zero();
    int above = the_world;
    for (int i = 0; i < links; ++i) {
      const int here = world.add(
          capsule(Real(0.07), link_length / 2 - Real(0.07), 1).at(end - Vec3(0, link_length / 2, 0)).coloured(i % 2));
      world.joints.push_back(ball_and_socket(world, above, here, end));
      end.y() -= link_length;
      above = here;
    }
    const int weight =
        world.add(box(Vec3::Constant(weight_half), mass_ratio).at(end - Vec3(0, weight_half, 0)).coloured(2));
    world.joints.push_back(ball_and_socket(world, above, weight, end));
    for (const Real y : {Real(0), end.y() - 2 * weight_half})  // bars behind its top and its lower end
      world.add(box({Real(1.2), Real(0.03), Real(0.03)}, 1).fixed().at({0, y, -Real(0.6)}));
  }
  /// The elongation of the chain, relative to the length of its links.
  Real stretch(const World& world) const {
    const Body& weight = world.bodies[static_cast<std::size_t>(links)];
    return point_of(weight, {0, weight_half, 0}).norm() / (static_cast<Real>(links) * link_length) - 1;
  }
};

}  // namespace pushback::joints_under_load_scenes
