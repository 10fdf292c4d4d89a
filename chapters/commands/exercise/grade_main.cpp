/// ./course grade
#include <thread>

#include "pushback/chapters/commands/exercise/all_exercises.h"
#include "pushback/chapters/commands/exercise/grade.h"
#include "pushback/chapters/commands/exercise/student_files.h"
#include "pushback/common/experiment/program.h"

using namespace pushback;

int main(int argc, char** argv) {
  Grading grading;
  std::vector<std::string> words;
  std::string points, shard = "1/1";
  bool no_sandbox = false;
  CLI::App app("Grades what students have handed in: a folder each, with files as 03_baumgarte_transfer.h.",
               "./course grade");
  app.add_option("FOLDER", grading.folders, "A folder for each student, named after the student")->required();
  app.add_option("--exercises", words, "03-transfer,04: these, instead of all transfer exercises")->delimiter(',');
  app.add_option("--points", points, "A file with the points of each check, as ./course handout writes it");
  app.add_option("--out", grading.out, "Where results go")->capture_default_str();
  app.add_option("--jobs", grading.jobs, "Students at the same time")->check(CLI::Range(1, 256))->capture_default_str();
  app.add_option(
      "--shard", shard,
      "2/5: the second of five parts, each for a machine of its own; with the same --out, the last one to end has all");
  app.add_option("--seed", grading.seed,
                 "Of all random scenes; by default drawn once, and kept in the folder of the results");
  app.add_option("--seconds", grading.limits.seconds, "For all checks of an exercise")
      ->check(CLI::Range(1, 3600))
      ->capture_default_str();
  app.add_option("--megabytes", grading.limits.megabytes, "Of memory")
      ->check(CLI::Range(64, 1 << 20))
      ->capture_default_str();
  app.add_flag("--no-sandbox", no_sandbox, "Run what students wrote with all rights that you have yourself");
  return run_program(app, argc, argv, [&] {
    const std::vector<Exercise> all = all_exercises();
    for (const std::string& word : words) grading.exercises.push_back(&exercise_named(all, word));
    for (const Exercise& exercise : all)
      if (words.empty() && exercise.transfer()) grading.exercises.push_back(&exercise);
    if (!points.empty()) grading.points = Points(all, points);
    grading.shard = shard_of(shard);
    grading.sandboxed = !no_sandbox;
    grade(grading);
  });
}
