/// A solver, and its dispatch, compiled in a file of its own choice: a dozen in one file take a minute.
#pragma once

#include "pushback/chapters/20_only_what_is_needed/dispatch.h"
#include "pushback/common/world/any_solver.h"

namespace pushback {

/// Defined by  template struct Compiled<...>;  in one of solvers_*.cpp.
template <class ContactSolver>
struct Compiled {
  static AnySolver solver();
  static OnlyWhatIsNeeded fitting(const World& world, std::optional<Sleep> sleep);
};

}  // namespace pushback
