/// Scenes for a single row, with a falling box, a box that is thrown upwards, and a reader's cube on a slope.
#pragma once

#include "pushback/common/world/situations.h"

namespace pushback::velocity_constraint_scenes {

struct DroppedBox {
  Real drop = Real(1.04);  ///< m, above the slab

  void operator()(World& world) const {
    slab(world);
    world.add(box(Vec3::Constant(Real(0.5)), 100).at({0, Real(0.5) + drop, 0}).coloured(2));
  }
};

struct LeavingBox {
  Real speed = 5;  ///< m/s, upwards

  static constexpr Real height = Real(0.49);  ///< m, of its centre, so that it is 1 cm deep in the slab

  void operator()(World& world) const {
    slab(world);
    world.add(box(Vec3::Constant(Real(0.5)), 100).at({0, height, 0}).moving({0, speed, 0}).coloured(2));
  }
  /// The greatest height of the box if nothing holds it, m. Its speed falls by g h in every step.
  Real highest_point(Real h) const {
    Real highest = height;
    for (Real v = speed - World::g * h; v > 0; v -= World::g * h) highest += h * v;
    return highest;
  }
};

/// A dropped box on the left, and another one on the right, released where it touches the underside of a plate.
struct DroppedAndUnderPlate {
  DroppedBox dropped;

  static constexpr Real aside = Real(1.1);      ///< m, of each box from the middle
  static constexpr Real height = Real(2.65);    ///< m, of the other box's centre, so that it is 1 cm deep in the plate
  static constexpr Real thickness = Real(0.1);  ///< m, of the plate

  void operator()(World& world) const {
    dropped(world);
    world.bodies.back().position.x() = -aside;
    world.add(
        box({Real(0.75), thickness / 2, Real(0.55)}, 1).fixed().at({aside, height + Real(0.49) + thickness / 2, 0}));
    world.add(box(Vec3::Constant(Real(0.5)), 100).at({aside, height, 0}).coloured(4));
  }
  /// The distance that a box falls if nothing holds it, m. Its speed grows by g h in each step.
  static Real fallen(Real time, Real h) {
    const Real steps = std::round(time / h);
    return World::g * h * h * steps * (steps + 1) / 2;
  }
};

/// Both boxes side by side, the dropped one on the left and the thrown one on the right.
struct DroppedAndThrown {
  DroppedBox dropped;
  LeavingBox thrown;

  static constexpr Real aside = Real(1.1);  ///< m, of each box from the middle

  void operator()(World& world) const {
    dropped(world);
    world.bodies.back().position.x() = -aside;
    world.add(box(Vec3::Constant(Real(0.5)), 100)
                  .at({aside, LeavingBox::height, 0})
                  .moving({0, thrown.speed, 0})
                  .coloured(4));
  }
};

struct CubeOnSlope {
  Real angle = Real(0.35);  ///< rad

  void operator()(World& world) const {
    incline(world, angle);
    const Vec3 up{-std::sin(angle), std::cos(angle), 0};
    world.add(box(Vec3::Constant(Real(0.5)), 100).turned(angle, Vec3::UnitZ()).at(Real(0.499) * up));
  }
  Real way_up(const World& world) const {
    return world.bodies.back().position.dot(Vec3(std::cos(angle), std::sin(angle), 0));
  }
};

}  // namespace pushback::velocity_constraint_scenes
