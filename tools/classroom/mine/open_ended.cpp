#include "pushback/tools/classroom/mine/open_ended.h"

#include <fmt/format.h>

#include <cstdlib>
#include <cstring>
#include <sstream>

#include "pushback/chapters/19_accuracy_and_time/motion.h"
#include "pushback/common/basics/files.h"
#include "pushback/common/basics/input.h"
#include "pushback/common/basics/process.h"
#include "pushback/common/basics/quantile.h"
#include "pushback/tools/classroom/kit.h"
#include "pushback/tools/classroom/mine/current_folder.h"
#include "pushback/tools/classroom/mine/lap.h"
#include "pushback/tools/classroom/mine/library.h"

namespace pushback {

namespace fs = std::filesystem;

namespace {

using Command = std::vector<std::string>;

std::string built_program(const std::string& name) {
  const fs::path program = program_beside(name);
  if (!fs::exists(program)) throw std::runtime_error("a program is needed that is not built: " + program.string());
  return program;
}

std::string without_line_end(std::string text) {
  while (text.ends_with('\n')) text.pop_back();
  return text;
}

/// Throws InvalidInput with the program's own words where it refuses what it was asked.
void ask(const Command& command) {
  const Ended ended = run_program(command, 60);
  if (ended.status == 2) throw InvalidInput(without_line_end(ended.err));
  if (ended.status != 0) throw std::runtime_error(fmt::format("{} failed: {}", command[0], last_line(ended.err)));
}

void make_mine(const MyFolder& mine, const fs::path& library, CompiledAs as) {
  const std::string wrong = make_library(mine.text(), fs::absolute(mine.path()), library, as);
  if (!wrong.empty()) throw std::runtime_error(wrong + ". ./course mine 00 shows all that the compiler says");
}

}  // namespace

bool play_hard_cases(const MyFolder& mine, const AskedOfHardCases& asked) {
  const fs::path to = fs::absolute(mine.path()) / "hard_cases";
  Command play{built_program("hard_cases_table")};
  play.insert(play.end(), asked.names.begin(), asked.names.end());
  if (!asked.all) play.insert(play.end(), {"--stages", "00,01,02,03,04,05,06,07,08"});
  Command list = play;
  list.emplace_back("--list");
  ask(list);
  const ScratchFolder scratch;
  const fs::path library = scratch.path / "solver.so";
  make_mine(mine, library, CompiledAs::exercise);
  if (asked.names.empty())
    fmt::print("All cases are played, which takes {}.\n", asked.all ? "minutes" : "about a minute");
  std::fflush(stdout);
  play.insert(play.end(), {"--mine", library, "--at-most", fmt::format("{}", asked.at_most), "--out", scratch.path});
  const CurrentFolder root(kit().sources);  // the table has links to the chapters' pages
  const Ended ended = run_program(play, 3600);
  const fs::path made = scratch.path / "hard_cases" / "part";
  if (!fs::exists(made / "overview.png"))
    throw std::runtime_error("there is no table: " +
                             (ended.signal != 0 ? strsignal(ended.signal) : last_line(ended.err)));
  // The table's last line names a file that is moved now.
  for (const std::string& line : lines_of(ended.out))
    if (line.find(scratch.path.string()) == line.npos) fmt::print("{}\n", line);
  std::fflush(stdout);
  fmt::print(stderr, "{}", ended.err);
  fs::remove_all(to);
  fs::copy(made, to, fs::copy_options::recursive);
  return ended.status == 0;
}

namespace {

struct Lane {
  std::string title;
  Command call;
  std::vector<double> times = {};  // ms a step
  std::string errors = {};
  std::string problem = {};
};

/// One run more of it, unless it had a problem.
void run(Lane& lane, double at_most) {
  if (!lane.problem.empty()) return;
  const Ended ended = run_program(lane.call, at_most);
  if (ended.out_of_time) lane.problem = fmt::format("no end within {:g} s", at_most);
  else if (ended.signal != 0) lane.problem = fmt::format("crashed: {}", strsignal(ended.signal));
  else if (ended.status != 0) lane.problem = last_line(ended.err);
  else if (const std::optional<Lap> lap = read_lap(ended.out)) {
    lane.times.push_back(lap->ms_per_step);
    const std::string errors = fmt::format("{:>11.4g} mm {:>11.4g} mm {:>11.4g} mm/s {:>11.4g} J", lap->overlap,
                                           lap->moved, lap->speed, lap->energy_gained);
    if (!lane.errors.empty() && lane.errors != errors)
      lane.problem = "two runs end differently: something in it begins with no value";
    lane.errors = errors;
  } else lane.problem = "it left the program before the scene was over";
}

}  // namespace

bool race(const MyFolder& mine, const AskedOfRace& asked) {
  const std::string program = built_program("mine_lap");
  const Command lap{program, asked.scene};
  const auto lap_of = [&](const std::string& option, const std::string& solver) {
    Command call = lap;
    call.insert(call.end(), {option, solver});
    return call;
  };
  ask({program, asked.scene, "--steps", "1", "--solver", recommended_name});
  const ScratchFolder scratch;
  const fs::path library = scratch.path / "solver.so";
  make_mine(mine, library, CompiledAs::chapter);
  std::vector<Lane> lanes{{"mine", lap_of("--mine", library)},
                          {plain_name, lap_of("--solver", plain_name)},
                          {recommended_name, lap_of("--solver", recommended_name)}};
  for (int i = 0; i < asked.runs; ++i)  // in turn: whatever else the machine does meets all of them alike
    for (Lane& lane : lanes) run(lane, asked.at_most);
  fmt::print("{}: {} steps of 1/60 s, {} runs each, in turn\n", asked.scene, lap_steps, asked.runs);
  fmt::print("{:<18} {:<28} {:>14} {:>14} {:>16} {:>13}\n", "", "ms a step (quartiles)", "overlap", "moved",
             "speed at end", "gained");
  for (const Lane& lane : lanes) {
    if (!lane.problem.empty()) fmt::print("{:<18} {}\n", lane.title, lane.problem);
    else
      fmt::print("{:<18} {:<28} {}\n", lane.title,
                 fmt::format("{:.4f} ({:.4f} to {:.4f})", median(lane.times), quantile(lane.times, 0.25),
                             quantile(lane.times, 0.75)),
                 lane.errors);
  }
  fmt::print(
      "overlap: the deepest in any step. moved: the way from its start of the body that is farthest from it; speed at "
      "end: of the\nfastest body: errors only where all should rest. gained: the most energy above the start's: an "
      "error, unless a motor runs\nor bodies begin inside each other.\n");
  return lanes.front().problem.empty();
}

void study_with_mine(const MyFolder& mine, const AskedOfStudy& asked) {
  const std::string program = built_program("study");
  built_program("motion_mine");
  std::vector<std::string> motions;
  for (const std::string& name : asked.motions) motions.push_back(motion_named(name).name);
  for (const Motion& motion : all_motions())
    if (asked.motions.empty() && motion.pins.empty()) motions.push_back(motion.name);
  const ScratchFolder scratch;
  const fs::path library = scratch.path / "solver.so", to = fs::absolute(mine.path()) / "study";
  make_mine(mine, library, CompiledAs::chapter);
  fmt::print("{} of the study's motions are played in all quick settings by every solver.\n", motions.size());
  std::fflush(stdout);
  Command study{program, "--quick", "--mine", library, "--out", scratch.path, "--only"};
  study.insert(study.end(), motions.begin(), motions.end());
  const Ended ended = run_program(study, 1800);
  const fs::path made = scratch.path / "19_accuracy_and_time";
  if (ended.status != 0 || !fs::exists(made / "work_precision.png")) {
    const std::string said = last_line(ended.err), before = "failed: ";  // the call of a motion, with all settings
    const std::size_t at = said.rfind(before);
    throw std::runtime_error("there are no diagrams: " + (at == said.npos ? said : said.substr(at + before.size())));
  }
  fs::remove_all(to);
  fs::create_directories(to);
  for (const char* file : {"work_precision.png", "others.md", "study.csv", "machine.md"})
    fs::copy(made / file, to / file);
}

}  // namespace pushback
