/// The numbers of an answer as a picture: yours beside what is right, and beside the mistake that they resemble.
#pragma once

#include <filesystem>

#include "pushback/tools/classroom/judge.h"

namespace pushback {

/// Leaves a picture of what was sent, a line for each number of each check; nothing, and no older picture either, where
/// nothing was. True where there is one.
bool write_result_sheet(const std::filesystem::path& file, const Exercise& exercise, std::uint64_t seed,
                        const Attempt& outcome, const Verdict& verdict);

}  // namespace pushback
