/// Many substeps instead of many sweeps.
#pragma once

#include "pushback/common/world/world.h"

namespace pushback {

/// A step of dt as `count` steps of dt / count, one sweep each. Contacts are detected anew in every one of them.
/// Macklin et al., "Small Steps in Physics Simulation", SCA 2019.
template <class ContactSolver>
void substeps(World& world, ContactSolver& solver, Real dt, int count, int sweeps = 1) {
  for (int i = 0; i < count; ++i) world.step(solver, dt / static_cast<Real>(count), sweeps);
}

}  // namespace pushback
