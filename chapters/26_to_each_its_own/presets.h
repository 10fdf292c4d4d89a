/// Three solvers to take where no chapter is the subject. Their prices: docs/which_solver.md
///
///   Recommended solver;
///   world.step(solver, 1.0 / 60);
#pragma once

#include "pushback/chapters/26_to_each_its_own/by_island.h"

namespace pushback {

/// For pictures and games: all in 8 substeps, in float. A stack of ten sinks by 7 mm, and more than 24 boxes on each other buckle
/// (chapter 12).
struct Fast : Wide<float> {
  Fast() {
    substeps = 8;
    stays_within = Real(5e-3);
  }
};

/// Each island by the step that it calls for: what is few is solved at once and to second order; piles in 32 substeps, in double.
struct Recommended : ByIsland {};

/// The same with errors 4 to 30 times smaller, in 1.5 to 3.5 times the time: piles in 128 substeps, half steps in 8 and more.
struct Exact : ByIsland {
  Exact() {
    many.substeps = 128;
    many.spring.hertz *= 4;  // as stiff as these substeps hold
    few.substeps = 8;
    joined.substeps = 8;
    energy = Real(1e-6);
  }
};

}  // namespace pushback
