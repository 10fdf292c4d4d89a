#include "pushback/tools/classroom/mine/verdict.h"

#include <fmt/ranges.h>

#include "pushback/common/basics/files.h"
#include "pushback/tools/classroom/attempt.h"
#include "pushback/tools/classroom/mine/chapters.h"

namespace pushback {

namespace {

constexpr std::size_t most_named = 3;  // mistakes with the same numbers; more would not help

/// The mistakes that would show the numbers of the first check that fails, and fail no check that was passed. Of these, those
/// that leave the fewest checks unexplained, and then those that explain the most; each name once.
std::vector<Slip> likely_slips(int chapter, const VerdictOfMine& made, std::uint64_t seed) {
  const std::vector<Passed>& checks = made.verdict.checks;
  /// Whether a mistake fails a check, and whether it reproduces the reader's numbers to a hundredth of the change that it makes.
  const auto shown = [&](const Slip& slip, std::size_t check) {
    const std::vector<Quantity>& quantities = made.exercise.checks[check].quantities;
    bool fails = false, same = true;
    for (std::size_t scene = 0; scene < scenes_of_a_check && (same || !fails); ++scene) {
      Random random = random_of(seed, check, scene);
      const Numbers mistaken = play(check, random, slip.solver), &right = made.verdict.right[check][scene];
      fails = fails || !passes(quantities, right, mistaken);
      same = same && are_alike(made.outcome.numbers[check][scene], mistaken, [&](std::size_t i) {
               return std::max<double>(quantities[i].tolerance, std::abs(mistaken[i] - right[i]) / 100);
             });
    }
    return std::pair(fails, same);
  };
  const std::size_t first = made.first_failing();
  std::vector<Slip> likely;
  std::pair<int, int> best;
  for (const Slip& slip : slips_in(chapter)) {
    // Checks of later chapters are left out, because the mistaken loop does not support their scenes.
    if (!holds(first, slip.chapter) || shown(slip, first) != std::pair(true, true)) continue;
    int explained = 0, unexplained = 0;
    bool contradicted = false;
    for (std::size_t i = 0; i < checks.size() && checks[i] != Passed::not_reached && !contradicted; ++i) {
      if (!holds(i, slip.chapter)) continue;
      const auto [fails, same] = shown(slip, i);
      contradicted = checks[i] == Passed::yes && fails;
      (same ? explained : unexplained) += 1;
    }
    const std::pair rank(-unexplained, explained);
    if (contradicted || (!likely.empty() && rank < best)) continue;
    if (rank > best) likely.clear();
    best = rank;
    if (std::none_of(likely.begin(), likely.end(), [&](const Slip& other) { return other.name == slip.name; }))
      likely.push_back(slip);
  }
  if (likely.size() > most_named) likely.clear();
  return likely;
}

}  // namespace

std::size_t VerdictOfMine::first_failing() const {
  std::size_t first = 0;
  while (first < verdict.checks.size() && verdict.checks[first] == Passed::yes) ++first;
  return first;
}

std::string VerdictOfMine::sentence() const {
  if (slips.empty()) return verdict.sentence;
  std::vector<std::string> names, hints;
  for (const Slip& slip : slips) {
    names.push_back(slip.name);
    hints.push_back(slip.hint);
  }
  const std::string &measured = verdict.sentence, end = " is right";  // what an exercise would add says less
  std::string words =
      fmt::format("{}. You get these numbers if {}. {}", measured.substr(0, measured.find(end) + end.size()),
                  fmt::join(names, ", or if "), fmt::join(hints, " "));
  if (!outcome.problem.empty()) words += " And then: " + outcome.problem;
  return words;
}

VerdictOfMine verdict_of_numbers(int chapter, const Attempt& outcome, std::uint64_t seed) {
  VerdictOfMine made{exercise_of_chapter(chapter), outcome, {}, {}};
  made.verdict = judge(made.exercise, seed, outcome);
  const std::size_t first = made.first_failing();
  if (first < made.verdict.checks.size() && made.verdict.checks[first] == Passed::no)
    made.slips = likely_slips(chapter, made, seed);
  return made;
}

VerdictOfMine verdict_of_mine(int chapter, const std::string& text, const std::filesystem::path& folder,
                              std::uint64_t seed) {
  Exercise exercise = exercise_of_chapter(chapter);
  exercise.folder = folder.string();
  const ScratchFolder scratch;
  write_text_file(scratch.path / "solver.h", text);
  return verdict_of_numbers(chapter, attempt(exercise, scratch.path / "solver.h", seed, nullptr), seed);
}

std::vector<Slip> slips_in(int chapter) {
  static const std::vector<Slip> all = slips_of_all();
  std::vector<Slip> in;
  for (int its = chapter; its >= 0; its = predecessor(its)) {
    for (const Slip& slip : all)
      if (slip.chapter == its || (chapter == 0 && slip.chapter == 1)) in.push_back(slip);
    if (its > 0)
      in.push_back(
          {its, fmt::format("the addition of chapter {} is missing", two_digits(its)),
           fmt::format("Your solver lacks it, or it has no effect, because these are the numbers of chapter {}.",
                       two_digits(predecessor(its))),
           plain_solver(predecessor(its))});
  }
  return in;
}

}  // namespace pushback
