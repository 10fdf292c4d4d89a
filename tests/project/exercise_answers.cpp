/// What students may write, exercise by exercise: called with the name of one, compiles each answer of
/// tests/NN_name/exercise/*.txt as `./course exercise` would, and compares the verdict with its title.
#include <fmt/format.h>

#include <set>

#include "pushback/tools/classroom/all_exercises.h"
#include "tests/support/answers.h"

using namespace pushback;

int main(int argc, char** argv) {
  const std::vector<Exercise> all = all_exercises();
  const Exercise& exercise = exercise_named(all, argc == 2 ? argv[1] : "");
  int failures = 0;
  std::set<std::string> missing{"right"};
  for (const auto& mistake : exercise.mistakes) missing.insert(mistake.name);
  const auto expect = [&](const std::string& name, const std::string& text) {
    const Verdict verdict = verdict_on(exercise, text, std::hash<std::string>{}(text));
    const bool nobody_knows = name == "right" || name.starts_with("unnamed: ");
    const bool as_expected = verdict.mistake == (nobody_knows ? "" : name) && verdict.passed() == (name == "right");
    fmt::print("{} {}: {}\n", as_expected ? "fine  " : "FAILED", name, verdict.passed() ? "passes" : verdict.sentence);
    failures += !as_expected;
    missing.erase(name);
  };
  for (const auto& [name, lines] : written_answers(exercise, SOURCE_DIR "/tests"))
    expect(name, filled_in(exercise, lines));
  const Verdict of_stub = verdict_on(exercise, read_text_file(stub_of(exercise)), 1);
  fmt::print("{} the gap as it is: {}\n", of_stub.passed() ? "FAILED" : "fine  ", of_stub.sentence);
  failures += of_stub.passed();
  for (const std::string& name : missing) fmt::print("FAILED: nobody writes '{}'\n", name);
  return failures + static_cast<int>(missing.size()) > 0;
}
