/// ./course exercise: what there is to do, and how far one's own file is from right.
#include <chrono>
#include <random>
#include <thread>

#include "pushback/chapters/commands/exercise/all_exercises.h"
#include "pushback/chapters/commands/exercise/attempt.h"
#include "pushback/chapters/commands/exercise/student_files.h"
#include "pushback/common/basics/files.h"
#include "pushback/common/basics/process.h"
#include "pushback/common/experiment/program.h"

using namespace pushback;

namespace fs = std::filesystem;

namespace {

struct Asked {
  std::vector<std::string> words;
  std::string folder;      // empty: exercises/ of the project
  std::uint64_t seed = 0;  // 0: another one each time
  bool hint = false, reset = false, watch = false;
};

std::string chapter_of(const Exercise& exercise) {
  return exercise.name.substr(3, exercise.name.find("_transfer") - 3);
}

void list(const std::vector<Exercise>& all, const StudentFiles& files) {
  const Exercise* next = nullptr;
  for (const Exercise& exercise : all) {
    int points = 0;
    for (const auto& check : exercise.checks) points += check.points;
    const std::string state = files.solved(exercise) ? "solved" : files.begun(exercise) ? "begun" : "";
    fmt::print("  {:<12} {:<7} {}: {}{}\n", short_name(exercise), state, chapter_of(exercise), exercise.title,
               exercise.transfer() ? fmt::format(" ({} points)", points) : "");
    if (!next && !files.solved(exercise)) next = &exercise;
  }
  if (next) fmt::print("next: ./course exercise {}\n", short_name(*next));
  else fmt::print("all are solved\n");
}

/// The lines of a verdict; true where all checks pass.
bool check(const Exercise& exercise, StudentFiles& files, std::uint64_t seed) {
  const fs::path file = files.file(exercise);
  const std::string text = read_text_file(file);
  fmt::print("{} {}: {}\n", short_name(exercise), chapter_of(exercise), exercise.title);
  if (untouched(text, read_text_file(stub_of(exercise)))) {
    fmt::print("\n  Nothing is written yet. The gap is in {}, line {}; the task is {}.\n", file.string(),
               line_of_todo(text), task_of(exercise).string());
    return false;
  }
  if (seed == 0) seed = std::random_device{}();
  const Outcome outcome = attempt(exercise, file, seed, nullptr);
  const Verdict verdict = judge(exercise, seed, outcome);
  for (std::size_t i = 0; i < exercise.checks.size(); ++i) {
    const Passed passed = verdict.checks[i];
    fmt::print("  {} {}\n", passed == Passed::yes ? "✓" : passed == Passed::no ? "✗" : "·", exercise.checks[i].says);
  }
  const std::vector<std::string> printed = lines_of(outcome.printed);
  for (std::size_t i = 0; i < std::min<std::size_t>(printed.size(), 10); ++i) fmt::print("  | {}\n", printed[i]);
  if (printed.size() > 10) fmt::print("  | ... and {} lines more that your file printed\n", printed.size() - 10);
  if (verdict.passed()) {
    fmt::print("\n  Solved.\n");
    files.set_solved(exercise);
    return true;
  }
  fmt::print("\n  {}{}\n\n  One hint more: ./course exercise {} --hint. The same scenes again: --seed {}\n",
             static_cast<char>(std::toupper(verdict.sentence[0])), verdict.sentence.substr(1), short_name(exercise),
             seed);
  return false;
}

void show_hints(const Exercise& exercise, StudentFiles& files) {
  const std::size_t count = std::min(files.hints(exercise) + 1, exercise.hints.size());
  for (std::size_t i = 0; i < count; ++i) fmt::print("  {}. {}\n", i + 1, exercise.hints[i]);
  if (count == exercise.hints.size()) fmt::print("  That was the last one. The page of the chapter has the rest.\n");
  files.set_hints(exercise, count);
}

[[noreturn]] void watch(const Exercise& exercise, StudentFiles& files, std::uint64_t seed) {
  fs::file_time_type seen{};
  for (;;) {
    std::error_code gone;
    const fs::file_time_type now = fs::last_write_time(files.file(exercise), gone);
    if (!gone && now != seen) {
      seen = now;
      fmt::print("\n");
      check(exercise, files, seed);
      std::fflush(stdout);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
  }
}

}  // namespace

int main(int argc, char** argv) {
  Asked asked;
  CLI::App app("Exercises that check themselves.", "./course exercise");
  app.add_option("EXERCISE", asked.words, "03, or 03-transfer; none: all are listed")->expected(0, 1);
  app.add_flag("--hint", asked.hint, "One hint more each time");
  app.add_flag("--reset", asked.reset, "The file as it was; yours is kept, with .old at its end");
  app.add_flag("--watch", asked.watch, "Check again at each save, until interrupted");
  app.add_option("--seed", asked.seed, "The same random scenes as last time");
  app.add_option("--in", asked.folder, "The folder with your files, exercises/ by default");
  bool passed = true;
  const int status = run_program(app, argc, argv, [&] {
    const std::vector<Exercise> all = all_exercises();
    StudentFiles files(asked.folder);
    if (asked.words.empty()) {
      if (asked.hint || asked.reset || asked.watch)
        throw InvalidInput("which exercise? Its number is needed, 03 for example");
      list(all, files);
      return;
    }
    const Exercise& exercise = exercise_named(all, asked.words[0]);
    if (asked.reset || !files.begun(exercise)) {
      files.reset(exercise);
      fmt::print("Your file is {}; the gap is in line {}. The task is {}.\n", files.file(exercise).string(),
                 line_of_todo(read_text_file(files.file(exercise))), task_of(exercise).string());
      if (!asked.watch) return;
    }
    if (asked.hint) show_hints(exercise, files);
    else if (asked.watch) watch(exercise, files, asked.seed);
    else passed = check(exercise, files, asked.seed);
  });
  return status == 0 && !passed ? 1 : status;
}
