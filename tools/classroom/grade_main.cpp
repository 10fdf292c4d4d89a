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
  CommandLine line("Grades what students have handed in: a folder or an archive each, with files as 03_baumgarte.h.",
                   "./course grade");
  line.option("FOLDER", grading.given,
              "For each student a folder, or an archive of one (.zip, .tar.gz), named after the student")
      .required();
  line.option("--exercises", words,
              "03,15-transfer,mine-06: these, instead of all that no page answers and all of your own, as far as "
              "--points names them")
      .split_at_commas();
  line.option("--points", points, "A file with the points of each check, as ./course run handout writes it");
  line.option("--out", grading.out, "Where results go").shows_default();
  line.option("--jobs", grading.jobs, "Students at the same time").between(1, 256).shows_default();
  line.option(
      "--shard", shard,
      "2/5: the second of five parts, each for a machine of its own; with the same --out, the last one to end has all");
  line.option("--seed", grading.seed,
              "Of all random scenes; by default drawn once, and kept in the folder of the results");
  line.option("--seconds", grading.limits.seconds,
              "Of processor time, for all checks of an exercise; six times as many by the clock")
      .between(1, 3600)
      .shows_default();
  line.option("--megabytes", grading.limits.megabytes, "Of memory").between(64, 1 << 20).shows_default();
  line.option("--compile-seconds", grading.limits.compile_seconds, "The same for the compiler")
      .between(1, 3600)
      .shows_default();
  line.flag("--no-sandbox", no_sandbox, "Run what students wrote with all rights that you have yourself");
  line.option("--tasks", tasks, "A folder with exercises of your own, a folder each: docs/teaching.md");
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
