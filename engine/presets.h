/// Three solvers with recommended settings. docs/which_solver.md gives their computing times.
///
///   Recommended solver;
///   solver.error = 1e-3;  // m, of the position after a second. Without it only the energy of each island is checked
///   world.step(solver, 1.0 / 60);
#pragma once

#include "pushback/engine/islands/twin_solver.h"
#include "pushback/engine/substeps/fast.h"  // Fast, for pictures and games

namespace pushback {

/// Gives each island the step that suits it. Islands with few contacts and resting islands are solved directly and to second order.
/// Tumbling islands are solved in 32 substeps in double precision, or by Fast if they are large. With `error`, each island gets as many
/// substeps as the error needs.
using Recommended = TwinSolver;

/// The same with 128 substeps, or at least 8 half steps. Its errors are 4 to 50 times smaller, unless they are 0, and it takes up to
/// 3.5 times as long.
struct Exact : TwinSolver {
  Exact() {
    substep_solver.substeps = 128;
    substep_solver.spring.hertz *= 4;  // as stiff as these substeps allow
    contact_half_step.substeps = 8;
    joint_half_step.substeps = 8;
    contact_half_step.most_work = joint_half_step.most_work = 1e7;
    energy = Real(1e-6);
    limits.large_pile = std::numeric_limits<int>::max();
    budget.per_contact *= 4;
  }
};

}  // namespace pushback
