/// What a compiler says, for who reads it for the first time.
#pragma once

#include <filesystem>
#include <string>

namespace pushback {

/// The first error in these messages of g++ or clang++: where it is, the line itself, and what it means.
std::string first_error(const std::string& messages, const std::filesystem::path& students_file);

}  // namespace pushback
