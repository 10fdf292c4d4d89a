#include "pushback/tools/classroom/judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

namespace pushback {

namespace {

bool is_whole(const Exercise::Line& check, const NumbersOfScenes& scenes) {
  return scenes.size() == scenes_of_a_check && std::all_of(scenes.begin(), scenes.end(), [&](const Numbers& numbers) {
           return numbers.size() == check.quantities.size() ||
                  (check.recorded && numbers.size() > check.quantities.size());
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

}  // namespace

NumbersOfScenes scenes_of(const Exercise::Played& answer, std::uint64_t seed, std::size_t check) {
  NumbersOfScenes scenes;
  for (std::size_t scene = 0; scene < scenes_of_a_check; ++scene) {
    Random random = random_of(seed, check, scene);
    scenes.push_back(answer(check, random));
  }
  return scenes;
}

std::string in_words(Real value, const Quantity& quantity) {
  const std::string digits = std::abs(value) < quantity.tolerance ? "0" : fmt::format("{:.3g}", value);
  return digits + (quantity.unit.empty() ? "" : " " + quantity.unit);
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
  const std::string should_be = in_words(right[*first][off.scene][off.quantity], quantity);
  if (std::isnan(is)) {
    verdict.mistake = "not a number";
    verdict.sentence = fmt::format(
        "{} NaN, which is not a number, where {} is right: look for 0/0, the root of a negative number, "
        "or a variable that nothing was written into.",
        quantity.words, should_be);
    return verdict;
  }
  verdict.sentence = fmt::format("{} {} where {} is right", quantity.words, in_words(is, quantity), should_be);

  // Of the mistakes that would show these numbers in this check, the one that also explains the most of the other checks.
  std::set<std::string> likely;
  const Exercise::Known* shows = nullptr;
  std::size_t most = 0;
  for (const auto& mistake : exercise.mistakes) {
    const NumbersOfScenes mistaken = scenes_of(mistake.played, seed, *first);
    if (furthest(quantities, right[*first], mistaken).by <= 1 || !resembles(quantities, right[*first], mistaken, shown))
      continue;
    std::size_t explained = 0;
    for (std::size_t i = 0; i < exercise.checks.size() && verdict.checks[i] != Passed::not_reached; ++i)
      explained +=
          resembles(exercise.checks[i].quantities, right[i], scenes_of(mistake.played, seed, i), outcome.numbers[i]);
    if (explained < most) continue;
    if (explained > most) likely.clear();
    most = explained;
    likely.insert(mistake.name);
    shows = &mistake;
  }
  if (likely.size() == 1) {
    verdict.mistake = *likely.begin();
    verdict.resembles = shows;
    verdict.sentence += ": " + shows->hint;
  } else {
    verdict.sentence += likely.empty() ? ". None of the mistakes that are known here shows these numbers." : ".";
  }
  if (!outcome.problem.empty()) verdict.sentence += " And then: " + outcome.problem;
  return verdict;
}

}  // namespace pushback
