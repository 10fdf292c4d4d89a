/// Loads a solver from a shared object, which may be compiled after the program.
#pragma once

#include <string>

#include "pushback/common/world/any_solver.h"

namespace pushback {

/// `library` exports   extern "C" pushback::StepSolver* make_solver(const pushback::StepSolver* like)
/// which returns a new solver, a copy of `like`, or one in its initial state if `like` is null. The library must be compiled with
/// the headers and the settings of this program. Throws InvalidInput if it cannot be loaded or lacks make_solver.
AnySolver loaded_solver(const std::string& library);

}  // namespace pushback
