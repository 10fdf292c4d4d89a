/// Three solvers to use as they are. Their prices: docs/which_solver.md
///
///   Recommended solver;
///   solver.error = 1e-3;  // m, of the position after a second. Without it only the energy of each island is checked
///   world.step(solver, 1.0 / 60);
#pragma once

#include "pushback/engine/islands/twin_solver.h"
#include "pushback/engine/substeps/fast.h"  // Fast, for pictures and games

namespace pushback {

/// Gives each island the step that fits it. Few contacts and resting islands are solved together and to second order, and
/// tumbling ones in 32 substeps, in double, or large ones as by Fast. With `error`, each island gets as many substeps as the error needs.
using Recommended = TwinSolver;

/// The same with errors 4 to 50 times smaller, unless they are 0, in up to 3.5 times the time: 128 substeps, half steps in 8 and more.
struct Exact : TwinSolver {
  Exact() {
    substep_solver.substeps = 128;
    substep_solver.spring.hertz *= 4;  // as stiff as these substeps hold
    contact_half_step.substeps = 8;
    joint_half_step.substeps = 8;
    contact_half_step.most_work = joint_half_step.most_work = 1e7;
    energy = Real(1e-6);
    limits.large = std::numeric_limits<int>::max();
    budget.per_contact *= 4;
  }
};

}  // namespace pushback
