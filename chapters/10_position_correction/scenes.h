/// Scenes with deep overlaps of a box in the ground, of boxes in each other, and of a ball, and a scene with a dropped ball.
#pragma once

#include "pushback/common/world/situations.h"

namespace pushback::position_correction_scenes {

inline constexpr Real very_deep = Real(0.25);  // m, for boxes of 1 m

inline void very_deep_box(World& world, Real depth = very_deep) {
  slab(world);
  world.add(box(Vec3::Constant(Real(0.5)), 100).at({0, Real(0.5) - depth, 0}).coloured(0));
}

/// Twelve boxes of 1 m, in three layers of two by two.   `apart`: distance from centre to centre, m
inline std::vector<Body> twelve_boxes(Real apart) {
  std::vector<Body> boxes;
  for (int row = 0; row < 3; ++row) {
    for (const int side : {-1, 1}) {
      for (const int behind : {-1, 1}) {
        boxes.push_back(box(Vec3::Constant(Real(0.5)), 100)
                            .at({static_cast<Real>(side) * apart / 2, Real(0.5) + static_cast<Real>(row) * apart,
                                 static_cast<Real>(behind) * apart / 2}));
      }
    }
  }
  return boxes;
}

inline void boxes_in_each_other(World& world) {
  world.add(ground());
  for (const Body& one : twelve_boxes(Real(0.7))) world.add(one);
}

struct WeightlessBall {
  Real depth = Real(0.06);  ///< m

  void operator()(World& world) const {
    world.gravity.setZero();
    world.add(ground());
    world.add(sphere(Real(0.5), 100).at({0, Real(0.5) - depth, 0}));
  }
  /// The depth that `count` corrections leave, m. Each removes the fraction `beta`, but at most `most` (m).
  Real left(Real beta, Real most, long count) const {
    Real overlap = depth;
    for (long i = 0; i < count; ++i) overlap -= std::min(beta * overlap, most);
    return overlap;
  }
};

/// A ball 1 m above the ground.
inline std::function<void(World&)> dropped_ball(Real e) {
  return [e](World& world) {
    world.add(ground());
    world.add(sphere(Real(0.3), 10).at({0, Real(1.3), 0}).bouncy(e));
  };
}

}  // namespace pushback::position_correction_scenes
