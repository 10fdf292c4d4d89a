/// A whole solver's verdict in a chapter.
#pragma once

#include <filesystem>

#include "pushback/tools/classroom/judge.h"

namespace pushback {

struct VerdictOfMine {
  Exercise exercise;  ///< of which these are the checks
  Attempt outcome;
  Verdict verdict;
  /// The first of `exercise`'s checks that does not pass; how many there are: all do.
  std::size_t first_failing() const;
};

/// `text`: of the file; headers in `folder` are found beside it.
VerdictOfMine verdict_of_mine(int chapter, const std::string& text, const std::filesystem::path& folder,
                              std::uint64_t seed);

}  // namespace pushback
