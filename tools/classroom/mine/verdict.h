/// A whole solver's verdict in a chapter, and which of the known mistakes its numbers show.
#pragma once

#include <filesystem>

#include "pushback/tools/classroom/judge.h"
#include "pushback/tools/classroom/mine/slips.h"

namespace pushback {

struct VerdictOfMine {
  Exercise exercise;  ///< of which these are the checks
  Attempt outcome;
  Verdict verdict;
  std::vector<Slip> slips;  ///< the known mistakes that give these numbers, or none if more than three would
  /// The error in words, with its probable cause.
  std::string sentence() const;
  /// The first of `exercise`'s checks that does not pass, or their number if all do.
  std::size_t first_failing() const;
};

/// `text`: the file's text. Headers in `folder` are found.
VerdictOfMine verdict_of_mine(int chapter, const std::string& text, const std::filesystem::path& folder,
                              std::uint64_t seed);
/// For the numbers that a solver has sent.
VerdictOfMine verdict_of_numbers(int chapter, const Attempt& outcome, std::uint64_t seed);

/// The mistakes that may be in a solver of this chapter: those of every chapter that it grows from, that what one of them adds is
/// missing, and for 00, which has one check that 01 keeps, those of 01.
std::vector<Slip> slips_in(int chapter);

}  // namespace pushback
