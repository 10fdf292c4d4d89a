/// A ball that is too deep in the ground. The other scenes are in chapter 11.
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

}  // namespace pushback::soft_contacts_scenes
