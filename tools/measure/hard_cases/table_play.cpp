/// Playing all of the table's pairs: on several threads, and some by processes of their own.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <limits>
#include <mutex>
#include <string_view>
#include <tuple>

#include "pushback/common/basics/files.h"
#include "pushback/common/basics/process.h"
#include "pushback/common/experiment/program.h"
#include "pushback/engine/substeps/thread_pool.h"
#include "pushback/tools/measure/hard_cases/table.h"

namespace pushback {

namespace fs = std::filesystem;

const Outcome* Table::find(const std::string& name, const std::string& stage) const {
  for (std::size_t row = 0; row < cases.size(); ++row) {
    for (std::size_t column = 0; column < stages.size(); ++column)
      if (cases[row].name == name && stages[column].name == stage && played(row, column)) return &at(row, column);
  }
  return nullptr;
}

Table assembled(std::vector<HardCase> cases, std::vector<Stage> stages, const std::vector<const Table*>& from) {
  Table table = empty_table(std::move(cases), std::move(stages));
  for (std::size_t pair = 0; pair < table.outcomes.size(); ++pair) {
    const std::string &name = table.cases[pair / table.stages.size()].name,
                      &stage = table.stages[pair % table.stages.size()].name;
    const Outcome* outcome = nullptr;
    for (const Table* one : from) outcome = outcome ? outcome : one->find(name, stage);
    if (!outcome) throw InvalidInput(fmt::format("{} was never played under {}: name it, too", name, stage));
    table.outcomes[pair] = *outcome;
  }
  return table;
}

Outcome best_of(const HardCase& hard_case, const Stage& stage,
                const std::function<Outcome(const Stage& one)>& outcome_of) {
  const auto rank = [&](const Outcome& outcome) {
    const std::size_t worst = outcome.worst(hard_case);
    const Real beyond = outcome.largest[worst] / hard_case.criteria[worst].limit;
    return std::tuple(outcome.passed(hard_case), outcome.possible(), outcome.ended, outcome.starts_passed,
                      outcome.broken.empty(), std::isfinite(beyond) ? -beyond : -std::numeric_limits<Real>::max());
  };
  std::optional<Outcome> best;
  for (const Stage& one : stage.tries) {
    Outcome outcome = outcome_of(one);
    outcome.by = one.name;
    if (!best || rank(outcome) > rank(*best)) best = std::move(outcome);
    if (best->passed(hard_case)) break;
  }
  return *best;
}

namespace {

/// Of a case without numbers.
Outcome without_end(const HardCase& hard_case, const std::string& why) {
  const std::vector<Real> nothing(hard_case.criteria.size(), std::numeric_limits<Real>::quiet_NaN());
  return {.numbers = nothing, .broken = why, .ended = false};
}

}  // namespace

/// One of several that are tried is given up sooner.
constexpr double most_seconds_of_a_try = 120;

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
  line.option("--setting", setting, "The stage or the solver").required();
  line.option("--hard-case", name, "The case").required();
  line.option("--starts", starts, "Largest number of starts").between(1, many_starts);
  line.option("--out", out, "The folder for table.csv and times.csv").required();
  return line.run(argc, argv, [&] {
    HardCase hard_case = hard_case_named(name);
    hard_case.starts = std::min(hard_case.starts, starts);
    const Table table = play({hard_case}, {stage_of(setting)}, 1, [](const Table&, std::size_t, std::size_t) {});
    write_text_file(fs::path(out) / "table.csv", table_csv(table));
    write_text_file(fs::path(out) / "times.csv", times_csv(table));
  });
}

Table play(std::vector<HardCase> cases, std::vector<Stage> stages, int threads, const Progress& progress,
           const GivingUp& giving_up) {
  Table table = empty_table(std::move(cases), std::move(stages));
  const std::size_t columns = table.stages.size(), pairs = table.cases.size() * columns;
  std::vector<std::size_t> left(table.cases.size(), columns);
  std::size_t rows = 0, done = 0;
  std::mutex mutex;
  std::atomic<int> given_up = 0;
  const auto best_of_tries = [&](const HardCase& hard_case, const Stage& stage) {
    return best_of(hard_case, stage, [&](const Stage& one) {
      {
        const std::lock_guard lock(mutex);
        if (const Outcome* known = table.find(hard_case.name, one.name)) return *known;
      }
      HardCase once = hard_case;  // one that fails from its first start needs no other
      once.starts = 1;
      Outcome outcome = outcome_apart(once, one, std::min(giving_up.seconds, most_seconds_of_a_try));
      if (hard_case.starts == 1 || !outcome.passed(once)) return outcome;
      return outcome_apart(hard_case, one, giving_up.seconds);
    });
  };
  const auto play_pair = [&](std::size_t i) {
    const HardCase& hard_case = table.cases[i / columns];
    const Stage& stage = table.stages[i % columns];
    Outcome outcome =
        !stage.tries.empty()  ? best_of_tries(hard_case, stage)
        : stage.apart.empty() ? outcome_of(hard_case, stage)
        : given_up < giving_up.times
            ? outcome_apart(hard_case, stage, giving_up.seconds)
            : without_end(hard_case, fmt::format("not played: {} cases before it had no end", given_up.load()));
    given_up += outcome.broken.starts_with(no_end) ? 1 : 0;
    const std::lock_guard lock(mutex);
    table.outcomes[i] = std::move(outcome);
    --left[i / columns];
    while (rows < left.size() && left[rows] == 0) ++rows;
    progress(table, rows, ++done);
  };
  ThreadPool pool(threads, true);
  pool.each(pairs, 1, [&](Part part) {
    for (std::size_t i = part.begin; i < part.end; ++i) play_pair(i);
  });
  return table;
}

}  // namespace pushback
