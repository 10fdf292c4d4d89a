/// What accuracy costs on one problem at a time: pictures, a table and all numbers.
#include <algorithm>
#include <iterator>

#include "pushback/common/basics/files.h"
#include "pushback/common/experiment/program.h"
#include "pushback/tools/measure/frozen/frozen.h"

using namespace pushback;
using namespace pushback::frozen;

namespace {

void draw(const FrozenPoints& points, const std::filesystem::path& to) {
  write_plot(to / "frozen.png", trace_panels(points));
  write_plot(to / "profiles.png", profile_panels(points));
}

/// Files and pictures of the whole; what the chapter's page shows is printed, too.
void show(const std::string& csv, const std::vector<FrozenProblem>& problems, const std::filesystem::path& to) {
  const FrozenPoints points = read_frozen_csv(csv);
  std::string page;
  for (const std::string& remark : remarks_of(points, problems)) page += "- " + remark + "\n";
  if (std::none_of(problems.begin(), problems.end(), [](const FrozenProblem& problem) { return problem.foreign; }))
    page += "- no folder of foreign problems was given: only our own are here\n";
  const std::string short_page = reached_of(points) + "\n" + page;
  fmt::print("{}", short_page);
  for (const std::string& table : tables_of(points)) page += "\n" + table;
  write_text_file(to / "reached.md", short_page);
  write_text_file(to / "frozen.md", page);
  write_text_file(to / "frozen.csv", csv);
  draw(points, to);
}

/// The large problems: tables alone.
void show_large(std::vector<FrozenProblem> foreign, bool quick, const std::filesystem::path& to) {
  make_writable_folder(to);
  std::vector<FrozenProblem> problems = large_problems();
  std::erase_if(foreign, [](const FrozenProblem& problem) { return problem.problem.contacts() < large_contacts; });
  std::move(foreign.begin(), foreign.end(), std::back_inserter(problems));
  std::string page;
  for (const std::string& table : tables_of(study_large(problems, quick))) page += (page.empty() ? "" : "\n") + table;
  fmt::print("{}", page);
  write_text_file(to / "large.md", page);
}

}  // namespace

int main(int argc, char** argv) {
  CommandLine line("Every method on every frozen problem: how far it comes in what time.");
  std::string folder, out = "renders";
  bool quick = false, redraw = false, large = false;
  line.flag("--quick", quick, "Seconds instead of minutes");
  line.flag("--redraw", redraw, "Solve nothing, and draw the pictures from frozen.csv");
  line.flag("--large", large,
            "Solve problems of hundreds and thousands of contacts instead, each once, which takes minutes, and write "
            "large.md");
  line.option("--problems", folder, "A folder of contact problems (*.dat) to solve in addition to our own")
      .from_environment("PUSHBACK_PROBLEMS");
  line.option("--out", out, "The folder in which the folder 19_accuracy_and_time is written").shows_default();
  return line.run(argc, argv, [&] {
    if (large && redraw) throw InvalidInput("--large cannot be combined with --redraw, because it has no pictures");
    const std::filesystem::path to = std::filesystem::path(out) / "19_accuracy_and_time";
    if (redraw) {
      draw(read_frozen_csv(read_text_file(to / "frozen.csv")), to);
      return;
    }
    std::vector<FrozenProblem> foreign;
    if (!folder.empty()) foreign = foreign_problems(folder);  // a bad one is said before anything is made or written
    if (large) {
      show_large(foreign, quick, to);
      return;
    }
    std::vector<FrozenProblem> problems = own_problems();
    std::move(foreign.begin(), foreign.end(), std::back_inserter(problems));
    make_writable_folder(to);
    show(csv_of(study_frozen(problems, quick)), problems, to);
  });
}
