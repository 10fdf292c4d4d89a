#include "pushback/tools/classroom/judge.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace pushback {

namespace {

bool is_whole(const Exercise::Line& check, const NumbersOfScenes& scenes) {
  return scenes.size() == scenes_of_a_check && std::all_of(scenes.begin(), scenes.end(), [&](const Numbers& numbers) {
           return numbers.size() == check.quantities.size();
         });
}

/// Which number is the furthest from the right one, in its tolerances.
struct Off {
  std::size_t scene = 0, quantity = 0;
  double by = 0;
};

Off furthest(const std::vector<Quantity>& quantities, const NumbersOfScenes& right, const NumbersOfScenes& scenes) {
  Off off;
  for (std::size_t scene = 0; scene < right.size(); ++scene) {
    for (std::size_t i = 0; i < quantities.size(); ++i) {
      const Real is = scenes[scene][i];
      double by = std::abs(is - right[scene][i]) / quantities[i].tolerance;
      if (!std::isfinite(is)) by = std::numeric_limits<double>::infinity();
      if (by > off.by) off = {scene, i, by};
    }
    if (off.by > 1) break;  // the first scene that shows something: one thing at a time
  }
  return off;
}

/// Whether these are the numbers of a mistake: to a hundredth of what it changes.
bool resembles(const std::vector<Quantity>& quantities, const NumbersOfScenes& right, const NumbersOfScenes& mistaken,
               const NumbersOfScenes& scenes) {
  for (std::size_t scene = 0; scene < right.size(); ++scene) {
    for (std::size_t i = 0; i < quantities.size(); ++i) {
      const Real is = scenes[scene][i], would_be = mistaken[scene][i];
      if (std::isnan(is) && std::isnan(would_be)) continue;
      const double tolerated = std::max<double>(quantities[i].tolerance, std::abs(would_be - right[scene][i]) / 100);
      if (!(std::abs(is - would_be) <= tolerated)) return false;
    }
  }
  return true;
}

/// As far as the numbers tell. A compiler may round otherwise where other code stands beside.
bool are_same(const std::vector<Quantity>& quantities, const Numbers& one, const Numbers& other) {
  if (one.size() != other.size() || one.size() != quantities.size()) return false;
  for (std::size_t i = 0; i < one.size(); ++i) {
    if (one[i] == other[i] || (std::isnan(one[i]) && std::isnan(other[i]))) continue;
    const Real rounding = 1000 * std::numeric_limits<Real>::epsilon() * std::abs(one[i]);
    if (!(std::abs(one[i] - other[i]) <= std::max<double>(rounding, quantities[i].tolerance / 1000))) return false;
  }
  return true;
}

/// Whether an answer is the file that it began as.
bool is_untouched(const Exercise& exercise, std::uint64_t seed, const Attempt& outcome) {
  if (!exercise.untouched) return false;
  for (std::size_t i = 0; i < outcome.numbers.size(); ++i) {
    const NumbersOfScenes gap = scenes_of(exercise.untouched, seed, i);
    for (std::size_t scene = 0; scene < outcome.numbers[i].size(); ++scene)
      if (scene >= gap.size() || !are_same(exercise.checks[i].quantities, gap[scene], outcome.numbers[i][scene]))
        return false;
  }
  return true;
}

/// The mistakes that would show the numbers of the check `first`, which fails, and fail no check that was passed. Of these,
/// those that leave the fewest checks unexplained, and then those that explain the most. In the exercise's order, each name
/// once.
std::vector<const Exercise::Known*> likely_mistakes(const Exercise& exercise, std::uint64_t seed,
                                                    const std::vector<NumbersOfScenes>& right, const Attempt& outcome,
                                                    const std::vector<Passed>& checks, std::size_t first) {
  std::vector<const Exercise::Known*> likely;
  std::pair<int, int> best;
  for (const auto& mistake : exercise.mistakes) {
    const auto fails = [&](std::size_t check, const NumbersOfScenes& mistaken) {
      return furthest(exercise.checks[check].quantities, right[check], mistaken).by > 1;
    };
    const auto shows = [&](std::size_t check, const NumbersOfScenes& mistaken) {
      return resembles(exercise.checks[check].quantities, right[check], mistaken, outcome.numbers[check]);
    };
    const NumbersOfScenes there = scenes_of(mistake.played, seed, first);
    if (there[0].empty() || !fails(first, there) || !shows(first, there)) continue;
    int explained = 0, unexplained = 0;
    bool contradicted = false;
    for (std::size_t i = 0; i < checks.size() && checks[i] != Passed::not_reached; ++i) {
      const NumbersOfScenes mistaken = scenes_of(mistake.played, seed, i);
      if (mistaken[0].empty()) continue;
      contradicted = contradicted || (checks[i] == Passed::yes && fails(i, mistaken));
      (shows(i, mistaken) ? explained : unexplained) += 1;
    }
    const std::pair rank(-unexplained, explained);
    if (contradicted || (!likely.empty() && rank < best)) continue;
    if (rank > best) likely.clear();
    best = rank;
    if (std::none_of(likely.begin(), likely.end(), [&](const auto* other) { return other->name == mistake.name; }))
      likely.push_back(&mistake);
  }
  return likely;
}

/// "0.31 m/s"; less than the tolerance is 0.
std::string in_words(Real value, const Quantity& quantity, int digits_shown) {
  const std::string digits = std::abs(value) < quantity.tolerance ? "0" : fmt::format("{:.{}g}", value, digits_shown);
  return digits + (quantity.unit.empty() ? "" : " " + quantity.unit);
}

constexpr std::size_t most_named = 3;  // of mistakes that show the same: more are no hint

constexpr const char* nothing_changes =
    ": your lines change nothing: the numbers are those of the file with the gap. Is a copy changed (`Row row = "
    "step.rows[i]` in the place of `Row& row`), or a result never used?";
constexpr const char* not_a_number =
    ": look for 0/0, the root of a negative number, or a variable that nothing was written into.";

void name_mistakes(Verdict& verdict, std::vector<const Exercise::Known*> likely) {
  if (likely.size() > most_named) likely.clear();
  std::vector<std::string> names, hints;
  for (const Exercise::Known* mistake : likely) {
    names.push_back(mistake->name);
    hints.push_back(mistake->hint);
  }
  verdict.mistake = fmt::format("{}", fmt::join(names, " or "));
  if (names.empty()) verdict.sentence += ". None of the mistakes that are known here shows these numbers alone.";
  else
    verdict.sentence +=
        fmt::format(": {}{}", names.size() > 1 ? "it is one of these: " : "", fmt::join(hints, " Or: "));
}

}  // namespace

NumbersOfScenes scenes_of(const Exercise::Played& answer, std::uint64_t seed, std::size_t check) {
  NumbersOfScenes scenes;
  for (std::size_t scene = 0; scene < scenes_of_a_check; ++scene) {
    Random random = random_of(seed, check, scene);
    scenes.push_back(answer(check, random));
  }
  return scenes;
}

std::string Verdict::in_words() const {
  if (passed()) return "Solved.";
  std::string words = sentence;
  words[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(words[0])));
  return words;
}

Verdict judge(const Exercise& exercise, std::uint64_t seed, const Attempt& outcome) {
  Verdict verdict;
  std::vector<NumbersOfScenes> right;
  std::optional<std::size_t> first;  // of the checks that fail
  for (std::size_t i = 0; i < exercise.checks.size(); ++i) {
    right.push_back(scenes_of(exercise.right, seed, i));
    const bool reached = i < outcome.numbers.size() && is_whole(exercise.checks[i], outcome.numbers[i]);
    const bool passed = reached && furthest(exercise.checks[i].quantities, right[i], outcome.numbers[i]).by <= 1;
    verdict.checks.push_back(!reached ? Passed::not_reached : passed ? Passed::yes : Passed::no);
    if (reached && !passed && !first) first = i;
  }
  if (!first) {
    verdict.sentence = outcome.problem;
    verdict.mistake = outcome.kind;
    if (!verdict.passed() && outcome.problem.empty()) {
      verdict.sentence = "your program ended before it had given all numbers.";
      verdict.mistake = "exit";
    }
    return verdict;
  }

  const auto& quantities = exercise.checks[*first].quantities;
  const NumbersOfScenes& shown = outcome.numbers[*first];
  const Off off = furthest(quantities, right[*first], shown);
  const Quantity& quantity = quantities[off.quantity];
  const Real is = shown[off.scene][off.quantity];
  int digits = 3;  // as many as tell the two apart
  const auto both = [&] {
    return std::pair{in_words(is, quantity, digits),
                     in_words(right[*first][off.scene][off.quantity], quantity, digits)};
  };
  while (both().first == both().second && digits < 12) ++digits;
  const auto [measured, should_be] = both();
  verdict.changes_nothing = is_untouched(exercise, seed, outcome);
  verdict.sentence = fmt::format("{} {} where {} is right", quantity.words, measured, should_be);
  if (verdict.changes_nothing) {
    verdict.mistake = "nothing changes";
    verdict.sentence += nothing_changes;
  } else if (std::isnan(is)) {
    verdict.mistake = "not a number";
    verdict.sentence =
        fmt::format("{} NaN, which is not a number, where {} is right{}", quantity.words, should_be, not_a_number);
    return verdict;
  } else if (!exercise.checks[*first].hint.empty()) {
    verdict.sentence += ": " + exercise.checks[*first].hint;
  } else {
    name_mistakes(verdict, likely_mistakes(exercise, seed, right, outcome, verdict.checks, *first));
  }
  if (!outcome.problem.empty()) verdict.sentence += " And then: " + outcome.problem;
  return verdict;
}

}  // namespace pushback
