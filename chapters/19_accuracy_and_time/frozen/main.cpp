/// What accuracy costs on one problem at a time: pictures, a table and all numbers.
#include "pushback/chapters/19_accuracy_and_time/frozen/frozen.h"
#include "pushback/chapters/19_accuracy_and_time/frozen/pictures.h"
#include "pushback/chapters/19_accuracy_and_time/frozen/problems.h"
#include "pushback/common/basics/files.h"
#include "pushback/common/experiment/program.h"

using namespace pushback;
using namespace pushback::frozen;

namespace {

void draw(const std::string& csv, const std::filesystem::path& to) {
  const FrozenPoints points = read_frozen_csv(csv);
  write_plot(to / "frozen.png", trace_panels(points));
  write_plot(to / "profiles.png", profile_panels(points));
}

}  // namespace

int main(int argc, char** argv) {
  CommandLine line("Every method on every frozen problem: how far it comes in what time.");
  FrozenOptions options;
  std::string folder, out = "renders";
  bool redraw = false;
  line.flag("--quick", options.quick, "Seconds instead of minutes");
  line.flag("--redraw", redraw, "Nothing is solved: pictures of what is in frozen.csv");
  line.option("--problems", folder, "A folder of contact problems (*.dat) to solve beside our own")
      .from_environment("PUSHBACK_PROBLEMS");
  line.option("--out", out, "Where the folder 19_accuracy_and_time is written to").shows_default();
  return line.run(argc, argv, [&] {
    const std::filesystem::path to = std::filesystem::path(out) / "19_accuracy_and_time";
    if (redraw) {
      draw(read_text_file(to / "frozen.csv"), to);
      return;
    }
    if (!folder.empty()) {
      options.folder = folder;
      foreign_problems(folder);  // a bad one is said before anything is written
    }
    make_writable_folder(to);
    const FrozenStudy study = study_frozen(options);
    std::string page;
    for (const std::string& remark : study.remarks) page += "- " + remark + "\n";
    fmt::print("{}", page);
    const std::string short_page = study.reached + "\n" + page;  // what the chapter's page shows
    for (const std::string& table : study.tables) page += "\n" + table;
    write_text_file(to / "reached.md", short_page);
    write_text_file(to / "frozen.md", page);
    write_text_file(to / "frozen.csv", study.csv);
    draw(study.csv, to);
  });
}
