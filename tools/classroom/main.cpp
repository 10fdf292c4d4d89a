/// ./course exercise: what there is to do, and how far one's own file is from right.
#include <chrono>
#include <random>
#include <thread>

#include "pushback/common/basics/files.h"
#include "pushback/common/basics/process.h"
#include "pushback/common/experiment/program.h"
#include "pushback/tools/classroom/attempt.h"
#include "pushback/tools/classroom/kit.h"
#include "pushback/tools/classroom/own_tasks.h"
#include "pushback/tools/classroom/package.h"
#include "pushback/tools/classroom/result_sheet.h"
#include "pushback/tools/classroom/student_files.h"

using namespace pushback;

namespace fs = std::filesystem;

namespace {

struct Asked {
  std::vector<std::string> words;
  std::string folder;  // empty: exercises/ of the project
  std::string tasks;
  std::string own_folder;  // to be made
  std::uint64_t seed = 0;  // 0: another one each time
  bool hint = false, reset = false, watch = false, all = false, no_sheet = false;
};

std::string chapter_of(const Exercise& exercise) {
  if (exercise.own()) return "own";
  return exercise.name.substr(3, exercise.name.find("_transfer") - 3);
}

void list(const std::vector<Exercise>& all, const StudentFiles& files) {
  const Exercise* next = nullptr;
  for (const Exercise& exercise : all) {
    int points = 0;
    for (const auto& check : exercise.checks) points += check.points;
    const std::string state = files.solved(exercise) ? "solved" : files.begun(exercise) ? "begun" : "";
    fmt::print("  {:<12} {:<7} {}: {}{}\n", short_name(exercise), state, chapter_of(exercise), exercise.title,
               exercise.graded() ? fmt::format(" ({} points)", points) : "");
    if (!next && !files.solved(exercise)) next = &exercise;
  }
  if (next) fmt::print("next: {} {}\n", kit().call(), short_name(*next));
  else fmt::print("all are solved\n");
}

/// The verdict, line by line, then the picture; true where all checks pass.
bool check(const Exercise& exercise, StudentFiles& files, const Asked& asked) {
  const fs::path file = files.file(exercise);
  const std::string text = read_text_file(file);
  fmt::print("{} {}: {}\n", short_name(exercise), chapter_of(exercise), exercise.title);
  if (untouched(text, read_text_file(stub_of(exercise)))) {
    fmt::print("\n  Nothing is written yet. The gap is in {}, line {}; the task is {}.\n", file.string(),
               line_of_todo(text), files.task(exercise).string());
    return false;
  }
  const std::uint64_t seed = asked.seed != 0 ? asked.seed : std::random_device{}();
  const Attempt outcome = attempt(exercise, file, seed, nullptr);
  static UntouchedFiles untouched_files;
  const Verdict verdict = judge(exercise, seed, outcome, [&] { return untouched_files.attempt(exercise, seed); });
  for (std::size_t i = 0; i < exercise.checks.size(); ++i) {
    const Passed passed = verdict.checks[i];
    fmt::print("  {} {}\n", passed == Passed::yes ? "✓" : passed == Passed::no ? "✗" : "·", exercise.checks[i].says);
  }
  const std::vector<std::string> printed = lines_of(outcome.printed);
  for (std::size_t i = 0; i < std::min<std::size_t>(printed.size(), 10); ++i) fmt::print("  | {}\n", printed[i]);
  if (printed.size() > 10) fmt::print("  | ... and {} lines more that your file printed\n", printed.size() - 10);
  fmt::print("\n  {}\n", verdict.in_words());
  if (verdict.passed()) files.set_solved(exercise);
  else
    fmt::print("\n  One hint more: {} {} --hint. The same scenes again: --seed {}\n", kit().call(),
               short_name(exercise), seed);
  std::fflush(stdout);  // the picture takes a moment
  const fs::path sheet = files.sheet(exercise);
  if (!asked.no_sheet && write_result_sheet(sheet, exercise, seed, outcome, verdict))
    fmt::print("  Your numbers beside the right ones, as a picture: {}\n", sheet.string());
  return verdict.passed();
}

/// What was written and is not yet solved, one after the other.
void check_all(const std::vector<Exercise>& all, StudentFiles& files, const Asked& asked) {
  for (const Exercise& exercise : all) {
    if (!files.begun(exercise) || files.solved(exercise)) continue;
    if (untouched(read_text_file(files.file(exercise)), read_text_file(stub_of(exercise)))) continue;
    check(exercise, files, asked);
    fmt::print("\n");
  }
  list(all, files);
}

void show_hints(const Exercise& exercise, StudentFiles& files) {
  const std::size_t count = std::min(files.hints(exercise) + 1, exercise.hints.size());
  for (std::size_t i = 0; i < count; ++i) fmt::print("  {}. {}\n", i + 1, exercise.hints[i]);
  if (count == exercise.hints.size()) fmt::print("  That was the last one. The page of the chapter has the rest.\n");
  files.set_hints(exercise, count);
}

[[noreturn]] void watch(const Exercise& exercise, StudentFiles& files, const Asked& asked) {
  fs::file_time_type seen{};
  for (;;) {
    std::error_code gone;
    const fs::file_time_type now = fs::last_write_time(files.file(exercise), gone);
    if (!gone && now != seen) {
      seen = now;
      fmt::print("\n");
      check(exercise, files, asked);
      std::fflush(stdout);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
  }
}

}  // namespace

int main(int argc, char** argv) {
  Asked asked;
  CommandLine line("Exercises that check themselves.", kit().call());
  line.option("EXERCISE", asked.words, "03, or 03-transfer; none: all are listed").at_most_once();
  line.flag("--hint", asked.hint, "One hint more each time");
  line.flag("--reset", asked.reset, "The file as it was; yours is kept, with .old at its end, then .old2, ...");
  line.flag("--watch", asked.watch, "Check again at each save, until interrupted");
  line.flag("--no-sheet", asked.no_sheet, "No picture of your numbers beside the right ones");
  line.option("--seed", asked.seed, "The same random scenes as last time");
  line.flag("--all", asked.all, "Every file that you have written in and that is not solved");
  line.option("--in", asked.folder, "The folder with your files, exercises/ by default");
  line.option("--tasks", asked.tasks, "A folder with exercises of your own, a folder each: docs/teaching.md");
  line.option("--new", asked.own_folder,
              "Make a folder of your own, which needs nothing but an installed Pushback: its build says the verdict");
  bool passed = true;
  const int status = line.run(argc, argv, [&] {
    const std::vector<Exercise> all = exercises_with(asked.tasks);
    if (!asked.own_folder.empty()) {
      std::vector<const Exercise*> exercises;
      for (const Exercise& exercise : all) exercises.push_back(&exercise);
      write_own_folder(asked.own_folder, exercises);
      fmt::print("{}: {} exercises, each with its task. What to do with them is in {}.\n", asked.own_folder, all.size(),
                 (fs::path(asked.own_folder) / "README.md").string());
      return;
    }
    StudentFiles files(asked.folder);
    if (asked.words.empty()) {
      if (asked.all) return check_all(all, files, asked);
      if (asked.hint || asked.reset || asked.watch)
        throw InvalidInput("which exercise? Its number is needed, 03 for example");
      list(all, files);
      return;
    }
    const Exercise& exercise = exercise_named(all, asked.words[0]);
    if (asked.reset || !files.begun(exercise)) {
      files.reset(exercise);
      fmt::print("Your file is {}; the gap is in line {}. The task is {}.\nWrite, save, and have it checked: {} {}\n",
                 files.file(exercise).string(), line_of_todo(read_text_file(files.file(exercise))),
                 files.task(exercise).string(), kit().call(), short_name(exercise));
      if (!asked.watch) return;
    }
    if (asked.hint) show_hints(exercise, files);
    else if (asked.watch) watch(exercise, files, asked);
    else passed = check(exercise, files, asked);
  });
  return status == 0 && !passed ? 1 : status;
}
