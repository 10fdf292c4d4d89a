#include "pushback/tools/measure/hard_cases/apart.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <string_view>

#include "pushback/common/basics/files.h"
#include "pushback/common/basics/process.h"
#include "pushback/common/experiment/program.h"
#include "pushback/tools/measure/hard_cases/table.h"

namespace pushback {

namespace fs = std::filesystem;

Outcome without_end(const HardCase& hard_case, const std::string& why) {
  const std::vector<Real> nothing(hard_case.criteria.size(), std::numeric_limits<Real>::quiet_NaN());
  return {.numbers = nothing, .broken = why, .ended = false};
}

Outcome outcome_apart(const HardCase& hard_case, const Stage& stage, double seconds) {
  const ScratchFolder scratch;
  std::vector<std::string> command = stage.apart;
  for (const std::string& word : {std::string("--hard-case"), hard_case.name, std::string("--starts"),
                                  std::to_string(hard_case.starts), std::string("--out"), scratch.path.string()})
    command.push_back(word);
  const Ended ended = run_program(command, seconds);
  if (ended.out_of_time) return without_end(hard_case, fmt::format("{} within {:g} s", no_end, seconds));
  if (ended.signal != 0) return without_end(hard_case, fmt::format("crashed: {}", strsignal(ended.signal)));
  const std::vector<std::string> said = lines_of(ended.err);
  if (ended.status != 0) return without_end(hard_case, "threw: " + (said.empty() ? "no words" : said.back()));
  if (!fs::exists(scratch.path / "times.csv")) return without_end(hard_case, "crashed: it left the program");
  Outcome outcome = read_table_csv(read_text_file(scratch.path / "table.csv"), {stage}).outcomes.front();
  const std::string times = lines_of(read_text_file(scratch.path / "times.csv")).back();
  outcome.ms_per_step = std::stod(times.substr(times.rfind(',') + 1));
  return outcome;
}

bool is_called_apart(int argc, const char* const* argv) {
  return argc > 1 && std::string_view(argv[1]) == "--setting";
}

int program_apart(int argc, const char* const* argv, const std::function<Stage(const std::string& setting)>& stage_of) {
  CommandLine line("Plays a hard case under one stage, for a program that makes a table.");
  std::string setting, name, out;
  int starts = many_starts;
  line.option("--setting", setting, "Which stage, or which solver").required();
  line.option("--hard-case", name, "The case").required();
  line.option("--starts", starts, "At most so many starts").between(1, many_starts);
  line.option("--out", out, "The folder for table.csv and times.csv").required();
  return line.run(argc, argv, [&] {
    HardCase hard_case = hard_case_named(name);
    hard_case.starts = std::min(hard_case.starts, starts);
    const Table table = play({hard_case}, {stage_of(setting)}, 1, [](const Table&, std::size_t, std::size_t) {});
    write_text_file(fs::path(out) / "table.csv", table_csv(table));
    write_text_file(fs::path(out) / "times.csv", times_csv(table));
  });
}

}  // namespace pushback
