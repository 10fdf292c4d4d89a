/// Contact problems that others wrote.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <vector>

#include "tests/support/catch.h"

namespace pushback {

/// Their files, in the order of their names. None, and a test says that it skips, where there are none.
inline std::vector<std::filesystem::path> foreign_problems() {
  const char* named = std::getenv("PUSHBACK_PROBLEMS");
  const std::filesystem::path folder = named != nullptr ? named : "../shared/data/contact_problems";
  std::vector<std::filesystem::path> files;
  if (std::filesystem::is_directory(folder))
    for (const auto& entry : std::filesystem::directory_iterator(folder))
      if (entry.path().extension() == ".dat") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  if (files.empty()) WARN("skipped: there are no contact problems in " << folder);
  return files;
}

}  // namespace pushback
