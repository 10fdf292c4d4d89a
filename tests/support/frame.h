#pragma once

#include "pushback/common/world/world.h"
#include "tests/support/yardstick.h"

/// The contacts of a scene, as a step would begin.
struct Frame {
  pushback::World world;
  template <class Fill>
  explicit Frame(Fill fill) {
    fill(world);
    world.begin_step(h);
  }
};
