/// A body that turns and one that arrives while contacts are kept, in addition to the stacks of earlier chapters.
#pragma once

#include "pushback/common/world/world.h"

namespace pushback::detected_once_scenes {

/// A cube of 1 m that starts on an edge and rolls over its edges on rough ground.
struct RollingCube {
  Real spin = 10;  ///< rad/s

  void operator()(World& world) const {
    const Real half_diagonal = std::sqrt(Real(0.5));
    world.add(ground().rough(1));
    world.add(box(Vec3::Constant(Real(0.5)), 100)
                  .turned(pi / 4, Vec3::UnitZ())
                  .at({0, half_diagonal, 0})
                  .moving({spin * half_diagonal, 0, 0})
                  .spinning({0, 0, -spin})
                  .rough(1));
  }
};

/// A ball that falls and arrives at a given speed.
struct FallingBall {
  Real speed = 10;               ///< m/s, as it arrives
  Real restitution = Real(0.8);  ///< e

  void operator()(World& world) const {
    world.add(ground().bouncy(restitution));
    world.add(sphere(Real(0.5), 10).at({0, Real(0.5) + speed * speed / (2 * World::g), 0}).bouncy(restitution));
  }
};

}  // namespace pushback::detected_once_scenes
