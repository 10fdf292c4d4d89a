/// The solvers of the chapters by their names, each compiled once, for programs and tests that choose at run time. No
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
  std::string what;  ///< in a line: its addition to the previous one, or its way to step
  AnySolver solver;  ///< with its default settings and its plan; to be copied
  std::function<OnlyWhatIsNeeded(const World&, std::optional<Sleep>)>
      fitting;  ///< for 07 and all together, the effects that the world needs; all effects for others
};

/// In the order of the chapters, one each, then later additions. All but the naive one support joints.
const std::vector<NamedSolver>& all_solvers();
/// Throws InvalidInput, naming all there are, where none has this name.
const NamedSolver& solver_named(const std::string& name);

}  // namespace pushback
