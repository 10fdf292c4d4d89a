/// What a compiler says, for who reads it for the first time.
#pragma once

#include <filesystem>
#include <string>

namespace pushback {

/// The first error in these messages of g++, clang++ or the linker: the line of the student's file that it comes from, also where
/// it shows elsewhere, the line itself, and what it means.
std::string first_error(const std::string& messages, const std::filesystem::path& students_file);

}  // namespace pushback
