/// What accuracy costs on one problem: every method on every frozen problem, how far it comes in what time.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace pushback::frozen {

struct FrozenOptions {
  bool quick = false;                                ///< a thirtieth of a second for each, fewer tolerances
  std::optional<std::filesystem::path> folder = {};  ///< of foreign problems; without: none
};

/// Sweeps, systems and residuals are the same whenever they are there; times, and so who is fastest, are those of the day.
struct FrozenStudy {
  std::vector<std::string> remarks;  ///< what the numbers say, a sentence each
  std::string reached;               ///< markdown, a row a method, with its heading
  std::vector<std::string> tables;   ///< markdown, one for each tolerance, with its heading
  std::string csv;                   ///< every point that was traced: what pictures.h draws
};

/// Takes minutes, or seconds if quick. Rounds go over all methods, one after the other, and then over all again. Throws
/// InvalidInput where the folder is not one of problems.
FrozenStudy study_frozen(const FrozenOptions& options);

}  // namespace pushback::frozen
