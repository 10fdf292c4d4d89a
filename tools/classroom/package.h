/// Folders for students: tasks, and files with gaps.
#pragma once

#include <filesystem>

#include "pushback/common/exercise/exercise.h"

namespace pushback {

/// A new folder with a task and a file with a gap for each exercise. `call`: what is typed to check one, in the place of
/// ./course exercise. Throws InvalidInput where the folder is there and not empty.
void write_tasks(const std::filesystem::path& folder, const std::vector<const Exercise*>& exercises,
                 const std::string& call);

/// Such a folder that needs nothing but an installed Pushback: its build says the verdict.
void write_own_folder(const std::filesystem::path& folder, const std::vector<const Exercise*>& exercises);

}  // namespace pushback
