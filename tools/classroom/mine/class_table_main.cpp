/// What ./course grade --hard-cases calls: a program of its own, as all solvers of the project are in it.
#include "pushback/common/experiment/program.h"
#include "pushback/tools/classroom/mine/class_table.h"

using namespace pushback;

int main(int argc, char** argv) {
  Grading grading;
  bool no_sandbox = false;
  CommandLine line("Plays the hard cases with each student's own solver.", "class_table");
  line.option("FOLDER", grading.given, "For each student a folder or an archive").required();
  line.option("--out", grading.out, "Where the folder hard_cases goes").shows_default();
  line.option("--jobs", grading.jobs, "Students at the same time").between(1, 256).shows_default();
  line.option("--megabytes", grading.limits.megabytes, "A quarter of the memory for a student's cases")
      .between(64, 1 << 20)
      .shows_default();
  line.flag("--no-sandbox", no_sandbox, "Run what students wrote with all rights that you have yourself");
  return line.run(argc, argv, [&] {
    grading.sandboxed = !no_sandbox;
    play_class(grading);
  });
}
