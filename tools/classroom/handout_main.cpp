/// ./course run handout: what a student gets.
#include <optional>

#include "pushback/common/basics/files.h"
#include "pushback/common/experiment/program.h"
#include "pushback/tools/classroom/grade.h"
#include "pushback/tools/classroom/mine/chapters.h"
#include "pushback/tools/classroom/own_tasks.h"
#include "pushback/tools/classroom/package.h"

using namespace pushback;

namespace fs = std::filesystem;

int main(int argc, char** argv) {
  fs::path folder, tasks;
  std::vector<std::string> with, without;
  std::string mine;
  CommandLine line(
      "Writes tasks and files with gaps into a folder, and the points of each check; no answers, no checks.",
      "./course run handout");
  line.option("FOLDER", folder, "A new folder").required();
  line.option("--with", with, "02,03,15-transfer: these; all by default").split_at_commas();
  line.option("--without", without, "04: all but these").split_at_commas();
  line.option("--mine", mine,
              "06: the points of a solver of the student's own, up to this chapter, for files mine/solver.h");
  line.option("--tasks", tasks, "A folder with exercises of your own, a folder each: docs/teaching.md");
  return line.run(argc, argv, [&] {
    const std::vector<Exercise> all = exercises_with(tasks);
    std::vector<const Exercise*> exercises = chosen(all, with, without);
    std::optional<Exercise> whole;
    if (!mine.empty()) whole = exercise_of_chapter(chapter_of_mine(mine).number);
    write_own_folder(folder, exercises);
    if (whole) exercises.push_back(&*whole);
    const fs::path points = fs::absolute(folder / "").parent_path().string() + ".points";
    write_text_file(points, points_text(exercises));
    fmt::print("{}: {} exercises{}. The points, for you and ./course grade --points: {}\n", folder.string(),
               exercises.size() - (whole ? 1 : 0), whole ? " and a solver of one's own" : "",
               fs::proximate(points).string());
  });
}
