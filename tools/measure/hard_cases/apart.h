/// A case played by a process of its own: another engine is a program, and a solver that somebody writes may crash, throw or never end.
#pragma once

#include "pushback/tools/measure/hard_cases/hard_case.h"

namespace pushback {

/// What `broken` begins with where the time was over.
inline constexpr const char* no_end = "no end";

/// stage.apart, the program and its arguments, plays the case, and is ended after so many seconds. See program_apart.
Outcome outcome_apart(const HardCase& hard_case, const Stage& stage, double seconds);

/// Of a case without numbers.
Outcome without_end(const HardCase& hard_case, const std::string& why);

/// Such a program:  PROGRAM --setting SETTING --hard-case NAME --starts COUNT --out FOLDER  plays the case under the stage of this
/// setting, and writes what outcome_apart reads. Returns the exit status.
int program_apart(int argc, const char* const* argv, const std::function<Stage(const std::string& setting)>& stage_of);
/// Whether a program is called so.
bool is_called_apart(int argc, const char* const* argv);

}  // namespace pushback
