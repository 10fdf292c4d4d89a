/// From numbers to a verdict: which checks pass, and what is wrong in the first that does not.
#pragma once

#include <algorithm>

#include "pushback/common/exercise/exercise.h"

namespace pushback {

/// The numbers measured in each scene of a check.
using NumbersOfScenes = std::vector<Numbers>;

/// What came of running an answer.
struct Attempt {
  std::vector<NumbersOfScenes> numbers;  ///< by check and scene, as far as it got
  std::string problem;                   ///< in plain words, why it got no further, or empty if it finished
  std::string kind;     ///< of the problem: "does not compile", "time", "memory", "crash", "exception", "exit"
  std::string printed;  ///< by the answer
};

/// Whether each number is within its tolerance of the right one.
bool passes(const std::vector<Quantity>& quantities, const Numbers& right, const Numbers& shown);
/// Whether these are the numbers of another answer, as far as `tolerated` says of each number.
bool are_alike(const Numbers& shown, const Numbers& other, const std::function<double(std::size_t)>& tolerated);

/// The numbers of a known answer.
NumbersOfScenes scenes_of(const Exercise::Played& answer, std::uint64_t seed, std::size_t check);

enum class Passed { yes, no, not_reached };

struct Verdict {
  std::vector<Passed> checks;
  std::string sentence;  ///< the problem with its number, or empty if there is none
  /// The kind of the problem, "nothing changes" or "not a number"; empty: none of these.
  std::string mistake;
  std::vector<NumbersOfScenes> right;  ///< the numbers of each check
  /// Whether the numbers equal those from the file with the gap.
  bool changes_nothing() const { return mistake == "nothing changes"; }
  bool passed() const {
    return !checks.empty() && std::all_of(checks.begin(), checks.end(), [](Passed one) { return one == Passed::yes; });
  }
};

Verdict judge(const Exercise& exercise, std::uint64_t seed, const Attempt& outcome);

}  // namespace pushback
