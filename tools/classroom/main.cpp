/// ./course exercise: lists the exercises, and checks the reader's files.
#include <random>

#include "pushback/common/basics/files.h"
#include "pushback/common/experiment/program.h"
#include "pushback/tools/classroom/attempt.h"
#include "pushback/tools/classroom/kit.h"
#include "pushback/tools/classroom/own_tasks.h"
#include "pushback/tools/classroom/package.h"
#include "pushback/tools/classroom/reader.h"
#include "pushback/tools/classroom/student_files.h"

using namespace pushback;

namespace fs = std::filesystem;

namespace {

struct Asked {
  std::vector<std::string> words;
  std::string folder;  // empty: exercises/ of the project
  std::string tasks;
  std::string own_folder;                  // to be made
  std::uint64_t seed = 0;                  // 0: another one each time
  std::vector<std::string> with, without;  // of those in the folder to be made
  bool hint = false, reset = false, watch = false, all = false;
};

std::string chapter_of(const Exercise& exercise) {
  if (exercise.own()) return "own";
  return exercise.name.substr(3, exercise.name.find("_transfer") - 3);
}

void list(const std::vector<Exercise>& all, const StudentFiles& files) {
  const Exercise* next = nullptr;
  for (const Exercise* listed : files.listed(all)) {
    const Exercise& exercise = *listed;
    int points = 0;
    for (const auto& check : exercise.checks) points += check.points;
    const std::string state = files.solved(exercise) ? "solved" : files.begun(exercise) ? "begun" : "";
    fmt::print("  {:<12} {:<7} {}: {}{}\n", short_name(exercise), state, chapter_of(exercise), exercise.title,
               exercise.graded() ? fmt::format(" ({} points)", points) : "");
    if (!next && !files.solved(exercise)) next = &exercise;
  }
  if (next) fmt::print("next: {} {}\n", kit().call(), short_name(*next));
  else fmt::print("all exercises are solved\n");
}

/// A compiler that is not done by then has been given something that never ends.
constexpr AttemptLimits limits{.compile_seconds = 20};

std::string heading(const Exercise& exercise) {
  return fmt::format("{} {}: {}\n", short_name(exercise), chapter_of(exercise), exercise.title);
}

struct Checked {
  bool passed = false;
  std::string lines;  ///< each check, and in the end the verdict
};

/// Compiles, runs and judges a file in which something is written.
Checked checked(const Exercise& exercise, StudentFiles& files, const Asked& asked) {
  std::string lines = heading(exercise);
  const std::uint64_t seed = asked.seed != 0 ? asked.seed : std::random_device{}();
  const Attempt outcome = attempt(exercise, files.file(exercise), seed, nullptr, limits);
  const Verdict verdict = judge(exercise, seed, outcome);
  for (std::size_t i = 0; i < exercise.checks.size(); ++i) lines += line_of(verdict.checks[i], exercise.checks[i].says);
  lines += lines_printed(outcome);
  if (verdict.passed()) files.set_solved(exercise);
  if (!verdict.passed())
    lines += fmt::format("  For another hint: {} {} --hint. For the same scenes again: --seed {}\n", kit().call(),
                         short_name(exercise), seed);
  return {verdict.passed(), lines + fmt::format("\n  {}\n", verdict.passed() ? "Solved." : capital(verdict.sentence))};
}

/// Prints the verdict on a file. True if all checks pass.
bool check(const Exercise& exercise, StudentFiles& files, const Asked& asked) {
  if (!files.begun(exercise)) {
    const fs::path file = files.file(exercise);
    fmt::print("{}\n  Nothing is written yet. The gap is in {}, line {}; the task is {}.\n", heading(exercise),
               file.string(), line_of_todo(read_text_file(file)), files.task(exercise).string());
    return false;
  }
  const Checked said = checked(exercise, files, asked);
  fmt::print("{}", said.lines);
  return said.passed;
}

/// Prints the list, then the verdicts on files with changes that are not yet solved. True if none is wrong.
bool check_all(const std::vector<Exercise>& all, StudentFiles& files, const Asked& asked) {
  std::string right, wrong, names;
  std::size_t count = 0, solved = 0;
  for (const Exercise& exercise : all) {
    if (!files.begun(exercise) || files.solved(exercise)) continue;
    const Checked one = checked(exercise, files, asked);
    ++count;
    solved += one.passed;
    (one.passed ? right : wrong) += fmt::format("\n{}", one.lines);
    if (!one.passed) names += fmt::format(" {}", short_name(exercise));
  }
  list(all, files);
  fmt::print("{}{}", right, wrong);
  if (count > 1)
    fmt::print("\n{} of {} checked exercises are solved{}\n", solved, count,
               names.empty() ? "" : fmt::format("; not yet:{}", names));
  return solved == count;
}

}  // namespace

int main(int argc, char** argv) {
  Asked asked;
  CommandLine line("Lists the exercises, or checks your file for one of them.", kit().call());
  line.option("EXERCISE", asked.words, "03 or 15-transfer, for example; without it, list all exercises").at_most_once();
  line.flag("--hint", asked.hint, "Show one more hint each time");
  line.flag("--reset", asked.reset,
            "Restore the original file; yours is kept, renamed to end in .old, then .old2, ...");
  line.flag("--watch", asked.watch, "Check again at each save, until interrupted");
  line.option("--seed", asked.seed, "Use this seed, for the same random scenes as last time");
  line.flag("--all", asked.all, "Check every file that you have changed and not yet solved");
  line.option("--in", asked.folder, "The folder with your files, exercises/ by default");
  line.option("--tasks", asked.tasks, "A folder with exercises of your own, a folder each (docs/teaching.md)");
  line.option("--new", asked.own_folder,
              "Make a folder of your own that needs only an installed Pushback; its build prints the verdicts");
  line.option("--with", asked.with, "02,03,15-transfer: put only these into the new folder; all by default")
      .split_at_commas();
  line.option("--without", asked.without, "04: put all except these into the new folder").split_at_commas();
  bool passed = true;
  const int status = line.run(argc, argv, [&] {
    const std::vector<Exercise> all = exercises_with(asked.tasks);
    if (!asked.own_folder.empty()) {
      if (!asked.words.empty())
        throw InvalidInput(fmt::format("--new makes a folder and checks nothing; to put '{0}' into it, add --with {0}",
                                       asked.words[0]));
      const std::vector<const Exercise*> exercises = chosen(all, asked.with, asked.without);
      write_own_folder(asked.own_folder, exercises);
      fmt::print("{}: {} exercise{}, each with its task. The next steps are in {}.\n", asked.own_folder,
                 exercises.size(), exercises.size() == 1 ? "" : "s",
                 (fs::path(asked.own_folder) / "README.md").string());
      return;
    }
    if (!asked.with.empty() || !asked.without.empty())
      throw InvalidInput("--with and --without apply to a new folder: --new FOLDER is needed");
    StudentFiles files(asked.folder);
    if (asked.words.empty()) {
      if (asked.all) {
        passed = check_all(all, files, asked);
        return;
      }
      if (asked.hint || asked.reset || asked.watch) throw InvalidInput("an exercise is needed, 03 for example");
      list(all, files);
      return;
    }
    const Exercise& exercise = exercise_named(all, asked.words[0]);
    if (asked.reset || !files.has(exercise)) {
      if (const fs::path kept = files.reset(exercise); !kept.empty())
        fmt::print("Your previous file is kept as {}\n", kept.string());
      fmt::print("Your file is {}; the gap is in line {}. The task is {}.\nWrite, save, and check it with: {} {}\n",
                 files.file(exercise).string(), line_of_todo(read_text_file(files.file(exercise))),
                 files.task(exercise).string(), kit().call(), short_name(exercise));
      if (!asked.watch) return;
    }
    if (asked.hint) files.show_hints(exercise.name, exercise.hints, "The page of the chapter");
    else if (asked.watch) watch(files.path(), [&] { check(exercise, files, asked); });
    else passed = check(exercise, files, asked);
  });
  return status == 0 && !passed ? 1 : status;
}
