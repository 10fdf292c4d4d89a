/// An answer that is a whole solver: a class of the reader's own, of which each scene gets a new one.
#pragma once

#include <memory>

#include "pushback/common/exercise/exercise.h"
#include "pushback/common/world/step_solver.h"

namespace pushback {

struct WholeSolver {
  std::function<std::unique_ptr<StepSolver>()> make;
};

/// Its settings are those that it has from the start.
template <class ContactSolver>
WholeSolver whole_solver() {
  return {[] { return std::make_unique<ContactSolver>(); }};
}

/// What is measured in a scene of a check, counted from 0 through all chapters.
Numbers play(std::size_t check, Random& random, const WholeSolver& answer);

}  // namespace pushback
