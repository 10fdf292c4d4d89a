#include "pushback/tools/measure/study/machine.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>

#include "pushback/tools/measure/results/markdown.h"

namespace pushback::study {

std::string load_now() {
  std::ifstream file("/proc/loadavg");
  std::string one, five, fifteen;
  return file >> one >> five >> fifteen ? fmt::format("{}, {}, {}", one, five, fifteen) : "unknown";
}

std::string table_of_machine(const MachineReport& run, const std::vector<Engine>& engines, const AllMeasured& all) {
  std::string text = "| measured | |\n| --- | --- |\n";
  text += fmt::format("| on | {} |\n", processor());
  text += fmt::format("| in | {:.0f} min, one program at a time |\n", std::ceil(run.took.count() / 60));
  if (run.resumed > 0) text += fmt::format("| motions measured before, by a run that was ended | {} |\n", run.resumed);
  text += fmt::format("| load of 1, 5, 15 min as it began | {} |\n", run.load_before);
  text += fmt::format("| as it ended, this run itself being 1 | {} |\n\n", run.load_after);
  text += markdown_heads({"engine", "version", "settings tried", "timed again near a front", "lost", "given up"});
  for (std::size_t i = 0; i < engines.size(); ++i) {
    int tried = 0, again = 0, lost = 0, late = 0;
    for (const auto& [motion, measured] : all) {
      for (const Measured& one : measured) {
        if (one.engine != engines[i].program) continue;
        ++tried;
        again += one.seconds.size() > 1 ? 1 : 0;
        late += one.late ? 1 : 0;
        lost += !one.late && !std::isfinite(one.error) ? 1 : 0;
      }
    }
    text += fmt::format("| {} | {} | {} | {} | {} | {} |\n", engines[i].title, run.versions.at(i), tried, again, lost,
                        late);
  }
  return text;
}

}  // namespace pushback::study
