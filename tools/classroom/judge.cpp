#include "pushback/tools/classroom/judge.h"

#include <fmt/format.h>

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

/// In tolerances.
double distance(const Quantity& quantity, Real right, Real is) {
  return std::isfinite(is) ? std::abs(is - right) / quantity.tolerance : std::numeric_limits<double>::infinity();
}

/// Which number is the furthest from the right one, in its tolerances.
struct Off {
  std::size_t scene = 0, quantity = 0;
  double by = 0;
};

Off furthest(const std::vector<Quantity>& quantities, const NumbersOfScenes& right, const NumbersOfScenes& scenes) {
  Off off;
  for (std::size_t scene = 0; scene < right.size(); ++scene) {
    for (std::size_t i = 0; i < quantities.size(); ++i)
      if (const double by = distance(quantities[i], right[scene][i], scenes[scene][i]); by > off.by)
        off = {scene, i, by};
    if (off.by > 1) break;  // the first scene with an error, because one message at a time is enough
  }
  return off;
}

/// Whether an answer is the file that it began as, as far as the numbers tell. A compiler may round otherwise where other code
/// stands beside.
bool is_untouched(const Exercise& exercise, std::uint64_t seed, const Attempt& outcome) {
  if (!exercise.untouched) return false;
  for (std::size_t i = 0; i < outcome.numbers.size(); ++i) {
    const NumbersOfScenes gap = scenes_of(exercise.untouched, seed, i);
    for (std::size_t scene = 0; scene < outcome.numbers[i].size(); ++scene) {
      const auto rounding = [&](std::size_t number) {
        return std::max<double>(1000 * std::numeric_limits<Real>::epsilon() * std::abs(gap[scene][number]),
                                exercise.checks[i].quantities[number].tolerance / 1000);
      };
      if (scene >= gap.size() || !are_alike(outcome.numbers[i][scene], gap[scene], rounding)) return false;
    }
  }
  return true;
}

/// "0.31 m/s"; less than the tolerance is 0.
std::string in_words(Real value, const Quantity& quantity, int digits_shown) {
  const std::string digits = std::abs(value) < quantity.tolerance ? "0" : fmt::format("{:.{}g}", value, digits_shown);
  return digits + (quantity.unit.empty() ? "" : " " + quantity.unit);
}

constexpr const char* nothing_changes =
    ": your lines change nothing, because the numbers are those of the file with the gap. Do you change a copy (`Row "
    "row = step.rows[i]` instead of `Row& row`), or never use a result?";
constexpr const char* not_a_number = ": look for 0/0, the root of a negative number, or an uninitialised variable.";

}  // namespace

NumbersOfScenes scenes_of(const Exercise::Played& answer, std::uint64_t seed, std::size_t check) {
  NumbersOfScenes scenes;
  for (std::size_t scene = 0; scene < scenes_of_a_check; ++scene) {
    Random random = random_of(seed, check, scene);
    scenes.push_back(answer(check, random));
  }
  return scenes;
}

bool passes(const std::vector<Quantity>& quantities, const Numbers& right, const Numbers& shown) {
  return furthest(quantities, {right}, {shown}).by <= 1;
}

bool are_alike(const Numbers& shown, const Numbers& other, const std::function<double(std::size_t)>& tolerated) {
  if (shown.size() != other.size()) return false;
  for (std::size_t i = 0; i < shown.size(); ++i)
    if (shown[i] != other[i] && !(std::isnan(shown[i]) && std::isnan(other[i])) &&
        !(std::abs(shown[i] - other[i]) <= tolerated(i)))
      return false;
  return true;
}

Verdict judge(const Exercise& exercise, std::uint64_t seed, const Attempt& outcome) {
  Verdict verdict;
  std::vector<NumbersOfScenes>& right = verdict.right;
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
  verdict.sentence = fmt::format("{} {}, but {} is right", quantity.words, measured, should_be);
  if (is_untouched(exercise, seed, outcome)) {
    verdict.mistake = "nothing changes";
    verdict.sentence += nothing_changes;
  } else if (std::isnan(is)) {
    verdict.mistake = "not a number";
    verdict.sentence =
        fmt::format("{} NaN, which is not a number, but {} is right{}", quantity.words, should_be, not_a_number);
    return verdict;
  } else {
    const std::string& hint = exercise.checks[*first].hint;
    verdict.sentence += hint.empty() ? "." : ": " + hint;
  }
  if (!outcome.problem.empty()) verdict.sentence += " And then: " + outcome.problem;
  return verdict;
}

}  // namespace pushback
