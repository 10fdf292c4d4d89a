/// A case played by a process of its own: a solver that somebody writes may crash, throw or never end.
#pragma once

#include "pushback/tools/hard_cases/hard_case.h"

namespace pushback {

/// The stage "mine" of a shared object; see common/experiment/loaded_solver.h. Throws InvalidInput where it is none.
Stage stage_of_library(const std::string& library);

/// What `broken` begins with where the time was over.
inline constexpr const char* no_end = "no end";

/// The program hard_cases_table plays the case with --alone, and is ended after so many seconds.
Outcome outcome_apart(const HardCase& hard_case, const Stage& stage, double seconds);

/// Of a case without numbers.
Outcome without_end(const HardCase& hard_case, const std::string& why);

}  // namespace pushback
