#include "pushback/tools/measure/hard_cases/apart.h"

#include <cstring>
#include <limits>

#include "pushback/common/basics/files.h"
#include "pushback/common/basics/process.h"
#include "pushback/common/experiment/loaded_solver.h"
#include "pushback/tools/measure/hard_cases/table.h"

namespace pushback {

namespace fs = std::filesystem;

Stage stage_of_library(const std::string& library) {
  Stage stage{{"mine", "your own, as it was when the table was made", loaded_solver(library), {}}};
  stage.apart = {fs::canonical("/proc/self/exe"), "--mine", library, "--alone"};
  return stage;
}

Outcome without_end(const HardCase& hard_case, const std::string& why) {
  const std::vector<Real> nothing(hard_case.criteria.size(), std::numeric_limits<Real>::quiet_NaN());
  return {.numbers = nothing, .broken = why, .ended = false};
}

Outcome outcome_apart(const HardCase& hard_case, const Stage& stage, double seconds) {
  const ScratchFolder scratch;
  std::vector<std::string> command = stage.apart;
  command.insert(command.begin() + 1, hard_case.name);
  command.insert(command.end(), {"--starts", std::to_string(hard_case.starts), "--out", scratch.path});
  const Ended ended = run_program(command, seconds);
  if (ended.out_of_time) return without_end(hard_case, fmt::format("{} within {:g} s", no_end, seconds));
  if (ended.signal != 0) return without_end(hard_case, fmt::format("crashed: {}", strsignal(ended.signal)));
  const std::vector<std::string> said = lines_of(ended.err);
  if (ended.status != 0) return without_end(hard_case, "threw: " + (said.empty() ? "no words" : said.back()));
  const fs::path folder = scratch.path / "hard_cases" / "part";
  if (!fs::exists(folder / "times.csv")) return without_end(hard_case, "crashed: it left the program");
  Outcome outcome = read_table_csv(read_text_file(folder / "table.csv"), {stage}).outcomes.front();
  const std::string times = lines_of(read_text_file(folder / "times.csv")).back();
  outcome.ms_per_step = std::stod(times.substr(times.rfind(',') + 1));
  return outcome;
}

}  // namespace pushback
