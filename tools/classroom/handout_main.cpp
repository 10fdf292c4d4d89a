/// ./course run handout: writes a folder for students.
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
      "Writes tasks, files with gaps, and the points of each check into a folder, without answers and checks.",
      "./course run handout");
  line.option("FOLDER", folder, "A new folder").required();
  line.option("--with", with, "02,03,15-transfer: only these; all by default").split_at_commas();
  line.option("--without", without, "04: all except these").split_at_commas();
  line.option("--mine", mine, "06: also write the points for a student's own solver mine/solver.h, up to this chapter");
  line.option("--tasks", tasks, "A folder with exercises of your own, a folder each (docs/teaching.md)");
  return line.run(argc, argv, [&] {
    const std::vector<Exercise> all = exercises_with(tasks);
    std::vector<const Exercise*> exercises = chosen(all, with, without);
    std::optional<Exercise> whole;
    if (!mine.empty()) whole = exercise_of_chapter(chapter_of_mine(mine).number);
    write_own_folder(folder, exercises);
    if (whole) exercises.push_back(&*whole);
    const fs::path points = fs::absolute(folder / "").parent_path().string() + ".points";
    write_text_file(points, points_text(exercises));
    fmt::print("{}: {} exercises{}. The points for you and for ./course grade --points are in {}\n", folder.string(),
               exercises.size() - (whole ? 1 : 0), whole ? " and a solver of one's own" : "",
               fs::proximate(points).string());
  });
}
