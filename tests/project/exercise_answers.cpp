/// The answers to an exercise, tests/NN_name/exercise/*.txt, judged as `./course exercise` would: what is right passes, and
/// what is wrong fails the checks that its title says. Together they are one student's file, which is compiled once.
#include <fmt/ranges.h>

#include "tests/support/answers.h"

using namespace pushback;

namespace {

/// Each answer in a namespace of its own, and one that plays the checks of all of them, one after the other.
std::string file_of(const Exercise& exercise, const std::vector<WrittenAnswer>& answers) {
  std::string text, cases;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    std::string one = filled_in(exercise, answers[i].lines);
    constexpr std::string_view space = "namespace student";
    one.replace(one.find(space), space.size(), fmt::format("namespace student_{}", i));
    text += one;
    cases += fmt::format("    case {}: return play(check % {}, random, student_{}::answer);\n", i,
                         exercise.checks.size(), i);
  }
  return text + fmt::format(R"(
namespace student {{
struct All {{}};
inline const All answer;
inline pushback::Numbers play(std::size_t check, pushback::Random& random, const All&) {{
  switch (check / {}) {{
{}  }}
  return {{}};
}}
}}
)",
                            exercise.checks.size(), cases);
}

/// The same checks for each of so many answers.
Exercise repeated(const Exercise& exercise, std::size_t answers) {
  Exercise all = exercise;
  for (std::size_t i = 1; i < answers; ++i)
    all.checks.insert(all.checks.end(), exercise.checks.begin(), exercise.checks.end());
  all.right = [&exercise](std::size_t check, Random& random) {
    return exercise.right(check % exercise.checks.size(), random);
  };
  return all;
}

}  // namespace

int main(int, char** argv) {
  const std::vector<Exercise> exercises = all_exercises();
  const Exercise& exercise = exercise_named(exercises, argv[1]);
  const std::vector<WrittenAnswer> answers = written_answers(exercise, SOURCE_DIR "/tests");
  const std::size_t count = exercise.checks.size();
  const Verdict verdict =
      verdict_on(repeated(exercise, answers.size()), file_of(exercise, answers), 1, nullptr, {.seconds = 100});
  int failures = 0;
  std::set<std::size_t> caught;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    std::set<std::size_t> fails;
    for (std::size_t check = 0; check < count; ++check)
      if (verdict.checks[i * count + check] != Passed::yes) fails.insert(check + 1);
    if (fails != answers[i].fails) {
      ++failures;
      fmt::print("FAILED: '{}' fails the checks {}\n", answers[i].title, fmt::join(fails, " "));
    }
    caught.insert(fails.begin(), fails.end());
  }
  for (std::size_t check = 1; check <= count; ++check)
    if (!caught.contains(check)) fmt::print("FAILED: no answer fails the check {}\n", check), ++failures;
  if (failures > 0) fmt::print("{}\n", verdict.sentence);
  return failures > 0;
}
