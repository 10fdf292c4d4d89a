/// ./course handout: what a student gets.
#include "pushback/common/basics/files.h"
#include "pushback/common/experiment/program.h"
#include "pushback/tools/classroom/grade.h"
#include "pushback/tools/classroom/own_tasks.h"
#include "pushback/tools/classroom/package.h"
#include "pushback/tools/classroom/student_files.h"

using namespace pushback;

namespace fs = std::filesystem;

namespace {

std::string how_to(const std::vector<const Exercise*>& exercises, const std::string& folder) {
  std::string text =
      "# Exercises\n\nFor each exercise there is a task (`.md`) and a file in which a few lines are left out (`.h`). "
      "Write these lines,\n"
      "and nothing else. To check them, in a copy of Pushback:\n\n";
  for (const Exercise* exercise : exercises)
    text += fmt::format("    ./course exercise {} --in PATH/TO/{}\n", short_name(*exercise), folder);
  return text + "\nHand in this folder, under your own name.\n";
}

}  // namespace

int main(int argc, char** argv) {
  fs::path folder, tasks;
  std::vector<std::string> with, without;
  CommandLine line(
      "Writes tasks and files with gaps into a folder, and the points of each check; no answers, no checks.",
      "./course handout");
  line.option("FOLDER", folder, "A new folder").required();
  line.option("--with", with, "02,03,03-transfer: these; all by default").split_at_commas();
  line.option("--without", without, "04: all but these").split_at_commas();
  line.option("--tasks", tasks, "A folder with exercises of your own, a folder each: docs/teaching.md");
  return line.run(argc, argv, [&] {
    const std::vector<Exercise> all = exercises_with(tasks);
    std::vector<const Exercise*> exercises;
    for (const std::string& word : with) exercises.push_back(&exercise_named(all, word));
    for (const Exercise& exercise : all)
      if (with.empty()) exercises.push_back(&exercise);
    for (const std::string& word : without) std::erase(exercises, &exercise_named(all, word));
    if (exercises.empty()) throw InvalidInput("--without leaves none: at least one exercise is needed");
    write_tasks(folder, exercises, "./course exercise");
    const std::string name = fs::absolute(folder / "").parent_path().filename().string();
    write_text_file(folder / "README.md", how_to(exercises, name));
    const fs::path points = fs::absolute(folder / "").parent_path().string() + ".points";
    write_text_file(points, points_text(exercises));
    fmt::print("{}: {} exercises. The points, for you and ./course grade --points: {}\n", folder.string(),
               exercises.size(), fs::proximate(points).string());
  });
}
