/// Folders for students: tasks, and files with gaps.
#pragma once

#include <filesystem>

#include "pushback/common/exercise/exercise.h"

namespace pushback {

/// Those of `all` that `with` names, or all where it names none, and not those that `without` names. Throws InvalidInput where a
/// name is unknown, or none is left. Points into `all`.
std::vector<const Exercise*> chosen(const std::vector<Exercise>& all, const std::vector<std::string>& with,
                                    const std::vector<std::string>& without);

/// A new folder with a task and a file with a gap for each exercise, a README.md, and a CMakeLists.txt with which a build says the
/// verdict. Throws InvalidInput where the folder is there and not empty, or cannot be made.
void write_own_folder(const std::filesystem::path& folder, const std::vector<const Exercise*>& exercises);

}  // namespace pushback
