/// A case played by a process of its own: a solver that somebody writes may crash, throw or never end.
#pragma once

#include "pushback/tools/measure/hard_cases/hard_case.h"

namespace pushback {

/// The stage "mine" of a shared object; see common/experiment/loaded_solver.h. Throws InvalidInput where it is none.
Stage stage_of_library(const std::string& library);

/// What `broken` begins with where the time was over.
inline constexpr const char* no_end = "no end";

/// The stage's program plays the case, and is ended after so many seconds. It gets the case's name, its own arguments, and --starts
/// and --out of hard_cases_table.
Outcome outcome_apart(const HardCase& hard_case, const Stage& stage, double seconds);

/// Of a case without numbers.
Outcome without_end(const HardCase& hard_case, const std::string& why);

}  // namespace pushback
