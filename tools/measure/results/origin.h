/// Where the results of a part come from: parts of different code are not put together, nor times of different machines.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pushback {

/// Of /proc/cpuinfo, and how many of them: "AMD EPYC 7B12, 2 cores".
std::string processor();
/// Of /proc/loadavg: how many programs wanted to run, in the mean of the last 1, 5 and 15 minutes. "unknown" where it is not there.
std::string load_now();

/// The commit is the one checked out where this program is, with a + where sources have changed since; "unknown" without git. Of
/// parts that begin later, PUSHBACK_COMMIT in the environment says it.
struct Origin {
  std::string machine;   ///< processor()
  std::string compiler;  ///< its version, and how it was called
  std::string commit;

  bool operator==(const Origin&) const = default;
};
Origin origin_here();

/// A line each. Written after all other files of a part, it says that the part is whole.
std::string origin_text(const Origin& origin);
/// Back from it. Throws InvalidInput where the file is missing or is none.
Origin read_origin(const std::filesystem::path& file);

/// Throws InvalidInput, naming both, where two of these parts are of different compilers or commits; or, where they were timed, of
/// different machines.
enum class Holds { numbers, times };
void require_one_origin(const std::vector<std::filesystem::path>& files, Holds holds);

/// The folders of so many parts of `folder`, each with a file of this name for its origin, and of one origin.
std::vector<std::filesystem::path> folders_of_parts(const std::filesystem::path& folder, std::size_t parts,
                                                    const std::string& origin, Holds holds);
/// This file of each of them.
std::vector<std::string> texts_of_parts(const std::vector<std::filesystem::path>& folders, const std::string& file);

}  // namespace pushback
