/// A reader's solver as a shared object in the project's own programs: see common/experiment/loaded_solver.h. These draw it and
/// measure it.
#pragma once

#include <vector>

#include "pushback/tools/classroom/mine/my_file.h"

namespace pushback {

enum class CompiledAs {
  exercise,  ///< quickly
  chapter    ///< with the settings of this build, for programs that measure time
};

/// Compiles the solver in `text` to `library`. Headers in `folder` are found by the text. Returns what went wrong, in words;
/// empty: nothing.
std::string make_library(const std::string& text, const std::filesystem::path& folder,
                         const std::filesystem::path& library, CompiledAs as);

/// Fills `to` with sheet.png, plot.png and numbers.md of the chapter's program, in which the solver in `library` plays each scene,
/// or only the first, with the sweeps and the step of the last variant. Returns the problem in words, or empty.
std::string draw_mine(int chapter, const std::filesystem::path& library, const std::filesystem::path& to,
                      bool all_scenes);

/// Fills hard_cases/ in the reader's folder with the table of the cases of these names (none: all), beside the stages that are a
/// plain loop. False where the solver came to no end in a case. Throws InvalidInput where a name is unknown, and
/// std::runtime_error where there is no table.
bool play_hard_cases(const MyFolder& mine, const std::vector<std::string>& names);

/// Fills study/ in the reader's folder with the diagrams of error against time in these motions (none: all without joints), the
/// reader's solver among ours. Throws as above, also where the solver came to no end.
void study_with_mine(const MyFolder& mine, const std::vector<std::string>& motions);

}  // namespace pushback
