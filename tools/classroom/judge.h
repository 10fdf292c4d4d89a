/// From numbers to a verdict: which checks pass, and which mistake it is that shows.
#pragma once

#include <algorithm>
#include <functional>
#include <map>

#include "pushback/common/exercise/exercise.h"

namespace pushback {

/// What is measured in each scene of a check.
using NumbersOfScenes = std::vector<Numbers>;

/// What came of running an answer.
struct Attempt {
  std::vector<NumbersOfScenes> numbers;  ///< by check and scene, as far as it got
  std::string problem;                   ///< in plain words, why it got no further; empty: it did
  std::string kind;     ///< of the problem: "does not compile", "time", "memory", "crash", "exception", "exit"
  std::string printed;  ///< by the answer
  /// What its scenes showed, by check and scene: see numbers_of in shown.h. For the picture alone, and not yet looked at.
  std::map<std::pair<std::size_t, std::size_t>, std::vector<Numbers>> shown = {};
};

/// What a known answer would have sent.
NumbersOfScenes scenes_of(const Exercise::Played& answer, std::uint64_t seed, std::size_t check);
/// "0.31 m/s"; less than the tolerance is 0.
std::string in_words(Real value, const Quantity& quantity, int digits_shown = 3);

enum class Passed { yes, no, not_reached };

struct Verdict {
  std::vector<Passed> checks;
  std::string sentence;  ///< what is wrong, with its number; empty: nothing
  /// The name of the one that shows, two or three where they show the same, with " or " between, or the kind of the problem;
  /// empty: none that is known.
  std::string mistake;
  const Exercise::Known* resembles = nullptr;  ///< the known one that shows, the first of two or three
  bool changes_nothing = false;                ///< its numbers are those of the file with the gap
  /// "Solved.", or the sentence, from its capital letter on.
  std::string in_words() const;
  bool passed() const {
    return !checks.empty() && std::all_of(checks.begin(), checks.end(), [](Passed one) { return one == Passed::yes; });
  }
};

/// What the file with the gap sends, as it is, with the same seed.
using Untouched = std::function<Attempt()>;

/// No mistake is named that fails a check which the answer has passed. `untouched` is asked where the answer fails; without it
/// nobody is told that his lines change nothing.
Verdict judge(const Exercise& exercise, std::uint64_t seed, const Attempt& outcome, const Untouched& untouched = {});

}  // namespace pushback
