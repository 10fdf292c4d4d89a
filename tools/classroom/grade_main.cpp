/// ./course grade
#include <thread>

#include "pushback/common/basics/input.h"
#include "pushback/common/experiment/program.h"
#include "pushback/tools/classroom/grade.h"
#include "pushback/tools/classroom/mine/chapters.h"
#include "pushback/tools/classroom/own_tasks.h"
#include "pushback/tools/classroom/student_files.h"

using namespace pushback;

int main(int argc, char** argv) {
  Grading grading;
  std::vector<std::string> words;
  std::string points, tasks, shard = "1/1";
  bool no_sandbox = false;
  CommandLine line(
      "Grades the submissions of students, a folder or an archive each, with files such as 03_baumgarte.h.",
      "./course grade");
  line.option("FOLDER", grading.given,
              "For each student a folder, or an archive of one (.zip, .tar.gz), named after the student")
      .required();
  line.option("--exercises", words,
              "03,15-transfer,mine-06: grade these; by default all exercises without an answer on a page and all of "
              "your own, limited to those in --points if given")
      .split_at_commas();
  line.option("--points", points, "A file with the points of each check, as ./course run handout writes it");
  line.option("--out", grading.out, "The folder for the results").shows_default();
  line.option("--jobs", grading.jobs, "Number of students graded at the same time").between(1, 256).shows_default();
  line.option("--shard", shard,
              "2/5: the second of five parts, for a machine of its own; with the same --out, the last part to finish "
              "has all results");
  line.option("--seed", grading.seed,
              "Seed of all random scenes; by default drawn once, and stored in the folder of the results");
  line.option("--seconds", grading.limits.seconds,
              "Limit of processor time for all checks of an exercise, in seconds; the wall-clock limit is six times as "
              "long")
      .between(1, 3600)
      .shows_default();
  line.option("--megabytes", grading.limits.megabytes, "Limit of memory, in MB").between(64, 1 << 20).shows_default();
  line.option("--compile-seconds", grading.limits.compile_seconds,
              "Limit of processor time for the compiler, in seconds")
      .between(1, 3600)
      .shows_default();
  line.flag("--no-sandbox", no_sandbox, "Run the students' code without a sandbox, with all of your own rights");
  line.option("--tasks", tasks, "A folder with exercises of your own, a folder each (docs/teaching.md)");
  return line.run(argc, argv, [&] {
    std::vector<Exercise> all = exercises_with(tasks);
    for (const ChapterOfMine& chapter : chapters_of_mine()) all.push_back(exercise_of_chapter(chapter.number));
    for (const std::string& word : words) grading.exercises.push_back(&exercise_named(all, word));
    if (!points.empty()) grading.points = Points(all, points);
    for (const Exercise& exercise : all)
      if (words.empty() && (points.empty() ? exercise.graded()
                                           : (exercise.graded() || exercise.whole()) && grading.points.has(exercise)))
        grading.exercises.push_back(&exercise);
    if (grading.exercises.empty())
      throw InvalidInput(
          fmt::format("--points: '{}' names no exercise that is graded; --exercises may name others", points));
    grading.shard = shard_of(shard);
    grading.sandboxed = !no_sandbox;
    grade(grading);
  });
}
