/// What the divided steps of a solver are compared with.
#pragma once

#include "pushback/common/world/step_solver.h"

namespace pushback {

/// `count` steps of dt / count: what Substeps of chapter 11 does in one step.
inline void substeps(World& world, StepSolver& solver, Real dt, int count, int sweeps = 1) {
  for (int i = 0; i < count; ++i) world.step(solver, dt / static_cast<Real>(count), sweeps);
}

}  // namespace pushback
