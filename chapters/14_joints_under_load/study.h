/// The error of a chain for a given number of sweeps.
#pragma once

#include "pushback/chapters/14_joints_under_load/scenes.h"
#include "pushback/common/world/steps_in.h"

namespace pushback::joints_under_load_scenes {

/// The largest elongation or shortening of the chain with the weight from 1 s to 4 s, relative to its length. `dt`: s.
template <class JointSolver>
Real worst_of_chain(const ChainWithWeight& chain, JointSolver solver, Real dt, int substeps, int sweeps) {
  World world;
  chain(world);
  const Real h = dt / static_cast<Real>(substeps);
  Real worst = 0;
  for (int step = 0; step < steps_in(4, h); ++step) {
    world.step(solver, h, sweeps);
    if (world.time >= 1) worst = std::max(worst, std::abs(chain.stretch(world)));
  }
  return worst;
}

}  // namespace pushback::joints_under_load_scenes
