/// What a compiler says of a student's file.
#pragma once

#include <filesystem>
#include <string>

namespace pushback {

/// The first error in the student's file among these messages of g++, clang++ or the linker, with the line that it is in. If all
/// show elsewhere: the first of them, with the line of the file that is named first.
std::string first_error(const std::string& messages, const std::filesystem::path& students_file);

}  // namespace pushback
