/// Three solvers to take where no chapter is the subject. Their prices: docs/which_solver.md
///
///   Recommended solver;
///   solver.error = 1e-3;  // m, of a place after a second; without it each island has the steps that chapter 26 gives it
///   world.step(solver, 1.0 / 60);
#pragma once

#include "pushback/engine/islands/within_error.h"

namespace pushback {

/// For pictures and games: all in 8 substeps, in float. A stack of ten sinks by 7 mm, and more than 24 boxes on each other buckle
/// (chapter 12).
struct Fast : Wide<float> {
  Fast() {
    substeps = 8;
    stays_within = Real(5e-3);
  }
};

/// Each island by the step that it calls for: what is few, or rests, is solved at once and to second order; what tumbles in 32
/// substeps, in double. With `error`, in as many as that calls for.
struct Recommended : WithinError {};

/// The same with errors 4 to 30 times smaller where there are any, in up to 2.5 times the time: 128 substeps, half steps in 8 and
/// more.
struct Exact : WithinError {
  Exact() {
    many.substeps = 128;
    many.spring.hertz *= 4;  // as stiff as these substeps hold
    few.substeps = 8;
    joined.substeps = 8;
    few.most_work = joined.most_work = 1e7;
    energy = Real(1e-6);
    savings.of_contact *= 4;
  }
};

}  // namespace pushback
