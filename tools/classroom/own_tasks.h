/// Exercises of a teacher's own, in a folder outside the project.
#pragma once

#include <filesystem>

#include "pushback/common/exercise/exercise.h"

namespace pushback {

/// All exercises, and behind them those in the folder `tasks`, if it is not empty: a folder each, with asked.h, student.h,
/// checks.cpp and task.md. Each is compiled if it has changed, and loaded into this program, because the teacher is trusted.
/// Throws InvalidInput where something of this is missing, or does not compile.
std::vector<Exercise> exercises_with(const std::filesystem::path& tasks);

}  // namespace pushback
