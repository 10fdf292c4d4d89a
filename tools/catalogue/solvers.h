/// The solvers of the chapters by their names, each compiled once: what programs and tests choose from while they run. No
/// chapter's header includes this.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "pushback/chapters/20_only_what_is_needed/dispatch.h"
#include "pushback/common/world/any_solver.h"

namespace pushback {

struct NamedSolver {
  std::string name;  ///< the chapter that it ends in, and a word or two: "07 warm start"
  std::string what;  ///< in a line: what it adds to the one before it, or how it steps
  AnySolver solver;  ///< with the settings that it has by itself, and its plan; to be copied
  std::function<OnlyWhatIsNeeded(const World&, std::optional<Sleep>)>
      fitting;  ///< of 07 and all together, what the world calls for; of others all
};

/// In the order of the chapters, one each; behind them what came after. All but the naive one hold joints.
const std::vector<NamedSolver>& all_solvers();
/// Throws InvalidInput, naming all there are, where none has this name.
const NamedSolver& solver_named(const std::string& name);

}  // namespace pushback
