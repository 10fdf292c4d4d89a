/// A stack of twenty, whose sweeps begin from nothing; a chain that carries a heavy load.
#pragma once

#include "pushback/chapters/09_joints/ball_and_socket.h"
#include "pushback/common/world/situations.h"

namespace pushback {

inline constexpr int boxes = 20;

inline constexpr Real sunk_at_start = Real(0.001);  // m, each into the one below, so that all contacts are there

/// A gate around it shows where it should stand, and how high.
inline void stack_in_gate(World& world) {
  const Real height = Real(boxes) + Real(0.16), thin = Real(0.05);
  for (const int side : {-1, 1})
    world.add(box({thin, height / 2, thin}, 1).fixed().at({static_cast<Real>(side), height / 2, 0}).coloured(6));
  world.add(box({1 + thin, thin, thin}, 1).fixed().at({0, height + thin, 0}).coloured(6));
  const std::size_t first = world.bodies.size() + 1;  // after the ground
  stack(world, boxes);
  for (std::size_t i = first; i < world.bodies.size(); ++i)
    world.bodies[i].position.y() -= static_cast<Real>(i - first + 1) * sunk_at_start;
}

/// m, from where it began.
inline Real height_lost_by_top(const World& world) {
  return Real(boxes) * (1 - sunk_at_start) - Real(0.5) - world.bodies.back().position.y();
}

inline constexpr int chain_links = 20;
inline constexpr Real chain_load = 1000;  // masses of a link
inline constexpr Real chain_length = 3;   // m, however many links
inline constexpr Real load_half = Real(0.4);

/// Links of 1 kg, ball and socket between them, that hang straight down from the origin; at the last one a box of `load` kg.
/// Behind it two bars: from where, and down to where it should hang.
inline void loaded_chain(World& world, int count, Real load) {
  const Real length = chain_length / static_cast<Real>(count), radius = std::min(Real(0.05), length / 4);
  Vec3 end = Vec3::Zero();
  int above = the_world;
  for (int i = 0; i <= count; ++i) {
    const int here =
        i == count
            ? world.add(box(Vec3::Constant(load_half), load).at(end - Vec3(0, load_half, 0)).coloured(2))
            : world.add(capsule(radius, length / 2 - radius, 1).at(end - Vec3(0, length / 2, 0)).coloured(i % 2));
    world.joints.push_back(ball_and_socket(world, above, here, end));
    above = here;
    if (i < count) end.y() -= length;
  }
  for (const Real y : {Real(0), end.y() - 2 * load_half})
    world.add(box({Real(1.2), Real(0.04), Real(0.04)}, 1).fixed().at({0, y, -Real(0.6)}).coloured(6));
}

inline void chain_with_heavy_load(World& world) {
  loaded_chain(world, chain_links, chain_load);
}
/// By how much it is longer than its links, of 1.
inline Real stretch_of_loaded_chain(const World& world) {
  return point_of(world.bodies[chain_links], {0, load_half, 0}).norm() / chain_length - 1;
}

}  // namespace pushback
