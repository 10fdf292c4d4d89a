/// Five piles, one of which is hit, and cubes that slide on ice.
#pragma once

#include "pushback/common/world/world.h"

namespace pushback::only_what_is_needed_scenes {

/// Five piles of six boxes, well apart. A ball rolls in from the front and hits the middle pile after about 1.4 s.
struct FivePiles {
  Real speed = 8;       ///< m/s, of the ball
  Real mass_ratio = 5;  ///< mass of the ball, in masses of a box

  void operator()(World& world) const {
    world.add(ground());
    for (int pile = 0; pile < 5; ++pile) {
      int colour = pile;  // each pile begins with a different one
      for (int row = 0; row < 3; ++row) {
        for (int i = 0; i < 3 - row; ++i, ++colour) {
          const Real x =
              Real(3.7) * static_cast<Real>(pile - 2) + Real(1.05) * (static_cast<Real>(i) - Real(2 - row) / 2);
          world.add(
              box(Vec3::Constant(Real(0.5)), 100).at({x, Real(0.5) + static_cast<Real>(row), 0}).coloured(colour));
        }
      }
    }
    constexpr Real radius = Real(0.7);
    const Vec3 way = Vec3(-Real(0.3), 0, -1).normalized();
    world.add(sphere(radius, 100 * mass_ratio)
                  .at(Vec3(0, radius, 0) - Real(12.5) * way)
                  .moving(speed * way)
                  .spinning(speed / radius * Vec3::UnitY().cross(way))
                  .coloured(5));
  }
};

/// Cubes that slide on ice in a tray, without friction or restitution. Each cube's inertia is the same about all axes.
inline void cubes_on_ice(World& world) {
  constexpr Real half = Real(0.5), side = 6;
  world.add(ground().rough(0));
  for (const Vec3& inwards : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 0, 1), Vec3(0, 0, -1)}) {
    const Vec3 along = inwards.cwiseAbs(), reach = Real(0.2) * along + side * (Vec3(1, 0, 1) - along);
    world.add(box(reach + Vec3(0, Real(0.4), 0), 1).fixed().rough(0).at(Vec3(0, Real(0.4), 0) - side * inwards));
  }
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) {
      const Vec3 where(Real(1.7) * (static_cast<Real>(i) - Real(2.5)), half,
                       Real(1.7) * (static_cast<Real>(j) - Real(2.5)));
      const Vec3 how =
          4 * Vec3(static_cast<Real>((3 * i + 5 * j) % 7 - 3), 0, static_cast<Real>((5 * i + 2 * j) % 7 - 3)) / 3;
      world.add(box(Vec3::Constant(half), 100).rough(0).at(where).moving(how));
    }
  }
}

}  // namespace pushback::only_what_is_needed_scenes
