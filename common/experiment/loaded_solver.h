/// A solver from a shared object, which was compiled after the program that it plays in.
#pragma once

#include <string>

#include "pushback/common/world/any_solver.h"

namespace pushback {

/// `library` exports   extern "C" pushback::StepSolver* make_solver(const pushback::StepSolver* like)
/// which returns a new solver: a copy of `like`, or one as it is from the start where that is null. It must have been compiled
/// with the headers and the settings of this program. Throws InvalidInput where there is no such library.
AnySolver loaded_solver(const std::string& library);

}  // namespace pushback
