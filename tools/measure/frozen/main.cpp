/// ./course study plays it after the motions: every method on every frozen problem, as two tables.
#include <algorithm>
#include <iterator>

#include "pushback/common/basics/files.h"
#include "pushback/common/basics/input.h"
#include "pushback/common/experiment/program.h"
#include "pushback/tools/measure/frozen/frozen.h"

using namespace pushback;
using namespace pushback::frozen;

int main(int argc, char** argv) {
  CommandLine line("Every method on every frozen problem: how long it takes until its residual is small.");
  std::string folder, out = "renders";
  bool quick = false, large = false;
  line.flag("--quick", quick, "Seconds instead of minutes");
  line.flag("--large", large,
            "Solve problems of hundreds and thousands of contacts instead, each once, which takes minutes, and write "
            "large.md");
  line.option("--problems", folder, "A folder of contact problems (*.dat) to solve in addition to our own")
      .from_environment("PUSHBACK_PROBLEMS");
  line.option("--out", out, "The folder in which the folder 19_accuracy_and_time is written").shows_default();
  return line.run(argc, argv, [&] {
    std::vector<FrozenProblem> foreign;
    if (!folder.empty()) foreign = foreign_problems(folder);  // a bad one is said before anything is made or written
    const std::filesystem::path to = std::filesystem::path(out) / "19_accuracy_and_time";
    make_writable_folder(to);
    constexpr Eigen::Index large_contacts = 400;
    if (large)
      std::erase_if(foreign, [](const FrozenProblem& frozen) { return frozen.problem.contacts() < large_contacts; });
    std::vector<FrozenProblem> problems = large ? large_problems() : own_problems();
    std::move(foreign.begin(), foreign.end(), std::back_inserter(problems));
    Limits limits;
    if (large) limits = {.seconds = 10, .work = 2e10};
    if (quick) limits = {.seconds = 0.03, .work = 1e8};
    const std::vector<Compared> rows = compare(problems, limits, large ? 1 : quick ? 3 : 7);
    if (large) {
      write_text_file(to / "large.md", tables_of(rows));
      fmt::print("{}", tables_of(rows));
      return;
    }
    write_text_file(to / "reached.md", reached_of(rows));
    write_text_file(to / "frozen.md", reached_of(rows) + "\n" + tables_of(rows));
    fmt::print("{}", reached_of(rows));
  });
}
