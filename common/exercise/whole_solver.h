/// An answer that is a whole solver: the reader's own class, of which each scene gets a new instance.
#pragma once

#include <memory>

#include "pushback/common/exercise/exercise.h"
#include "pushback/common/world/step_solver.h"

namespace pushback {

struct WholeSolver {
  std::function<std::unique_ptr<StepSolver>()> make;
};

/// Makes solvers with their default settings.
template <class ContactSolver>
WholeSolver whole_solver() {
  return {[] { return std::make_unique<ContactSolver>(); }};
}

/// The numbers that a scene of a check measures. `check` counts from 0 through all chapters.
Numbers play(std::size_t check, Random& random, const WholeSolver& answer);

}  // namespace pushback
