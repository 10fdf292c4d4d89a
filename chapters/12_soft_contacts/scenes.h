/// A ball that is too deep, beside the scenes of chapter 11.
#pragma once

#include "pushback/chapters/11_substeps/scenes.h"

namespace pushback::soft_contacts_scenes {

struct SunkenBall {
  Real depth = Real(0.05);  ///< m

  void operator()(World& world) const {
    world.gravity.setZero();
    world.add(ground());
    world.add(sphere(Real(0.5), 100).at({0, Real(0.5) - depth, 0}));
  }
};

/// The boxes of a stack, each as much lower as the soft contacts below it have yielded at rest.   `yield`: m, of the contact
/// of a single box with the ground; `magnified`: how many times as far down they are
inline std::vector<Body> stack_that_has_yielded(int count, Real yield, Real magnified) {
  std::vector<Body> boxes;
  Real down = static_cast<Real>(count) * yield;
  for (int i = 0; i < count; ++i) {
    boxes.push_back(
        box(Vec3::Constant(Real(0.5)), 100).at({0, Real(0.5) + static_cast<Real>(i) - magnified * down, 0}));
    down += 2 * static_cast<Real>(count - 1 - i) * yield;
  }
  return boxes;
}

}  // namespace pushback::soft_contacts_scenes
