/// The table of hard cases under other engines: what is written, and the program that hands the cases on. What an engine does with
/// them is looked at where the engine is: tests/19_accuracy_and_time/peers.cpp.
#include "pushback/tools/measure/hard_cases/peers.h"

#include <algorithm>
#include <limits>

#include "pushback/common/basics/named.h"
#include "tests/support/call.h"
#include "tests/support/complaint.h"

#ifndef PEERS_PROGRAM
#define PEERS_PROGRAM "build/release/programs/hard_cases_peers"
#endif

using namespace pushback;

namespace {

constexpr Real not_a_number = std::numeric_limits<Real>::quiet_NaN();

/// Of one criterion whose limit is 1: P passes, F fails, N is not possible.
Outcome outcome(char mark) {
  if (mark == 'N') return {.numbers = {not_a_number}, .broken = "not possible: a cone limit"};
  return {.numbers = {mark == 'P' ? Real(0.5) : Real(2)}, .broken = ""};
}

/// A row each: the marks of ours, and those of the engines, of which the last is that of all further ones.
Table table_of(const std::vector<std::pair<std::string, std::string>>& rows) {
  Table table;
  table.stages = stages_beside_peers();
  table.chapters = table.stages.size();
  table.rescues = false;
  for (const Stage& stage : peer_stages()) table.stages.push_back(stage);
  for (const auto& [ours, engines] : rows) {
    HardCase c;
    c.name = fmt::format("case-{}", table.cases.size());
    c.criteria = {{"drift", "mm", 1}};
    table.cases.push_back(c);
    std::string marks = ours + engines;
    marks.resize(table.stages.size(), engines.back());  // the rest as the last one
    for (const char mark : marks) table.outcomes.push_back(outcome(mark));
  }
  return table;
}

}  // namespace

TEST_CASE("what an engine does not have is neither passed nor failed, and is said") {
  const Table table = table_of({{"PPPP", "PNFNNN"}});
  CHECK(outcome('P').possible());
  CHECK(outcome('F').possible());
  CHECK_FALSE(outcome('N').possible());
  CHECK_FALSE(table.passed(0, 5));
  const std::string page = peers_md(table, "renders/hard_cases");
  CHECK(contains(page, "|  | ✓ | —<br>no cone limit | ✗ 2 mm | —<br>no cone limit |"));
  CHECK(contains(page, "| **1 of 1** | **0 of 1** | **0 of 1** |"));
  CHECK_FALSE(contains(page, "★"));
  CHECK_FALSE(rescuer(table, 0));
}

TEST_CASE(
    "ten settings of each engine, and of ours; the best of them is the first that passes, or else the nearest to it") {
  std::vector<Stage> columns = peer_stages();
  columns.push_back(stages_beside_peers().back());
  long bests = 0;
  for (const Stage& stage : columns) {
    if (stage.tries.empty()) continue;
    ++bests;
    INFO(stage.name);
    CHECK(contains(stage.name, " best of ten"));
    std::vector<std::string> names = names_of(stage.tries);
    std::ranges::sort(names);
    CHECK(std::ranges::unique(names).begin() - names.begin() == 10);
  }
  CHECK(bests == 6);
  HardCase c;
  c.criteria = {{"drift", "mm", 1}};
  const auto best = [&](const std::string& marks) {
    std::size_t i = 0;
    Outcome outcome_of_best = best_of(c, columns.back(), [&](const Stage& one) {
      CHECK(one.name == columns.back().tries[i].name);
      Outcome found = outcome(marks.at(i++));
      if (marks[i - 1] == 'f') found.largest = {Real(1.5)};
      if (marks[i - 1] == 's') found.starts_passed = 1;
      return found;
    });
    for (i = 0; outcome_of_best.by != columns.back().tries[i].name;) ++i;
    return i;
  };
  CHECK(best("FFP") == 2);         // and no other is tried
  CHECK(best("NFFfFFFFFF") == 3);  // nearest to its limit
  CHECK(best("NFFfFFsFFF") == 6);  // passes from one of its starts
  CHECK(best("NNNNNNNNNN") == 0);
}

TEST_CASE("the committed outcomes are of every case under every setting, and its page is what they make") {
  const std::string csv = text_of("renders/hard_cases/peers.csv");
  const Table peers = read_table_csv(csv, peer_stages());
  CHECK(table_csv(peers) == csv);
  REQUIRE(peers.stages.size() == peer_stages().size());
  for (const HardCase& hard_case : hard_cases()) {
    INFO(hard_case.name << ": where it is missing, ./course hard-cases --peers " << hard_case.name << " -- --renew");
    const auto played = std::find_if(peers.cases.begin(), peers.cases.end(),
                                     [&](const HardCase& c) { return c.name == hard_case.name; });
    REQUIRE(played != peers.cases.end());
    for (std::size_t i = 0; i < hard_case.criteria.size(); ++i)
      CHECK(played->criteria[i].limit == hard_case.criteria[i].limit);
    for (std::size_t column = 0; column < peers.stages.size(); ++column) {
      const Outcome& there = peers.at(static_cast<std::size_t>(played - peers.cases.begin()), column);
      if (!peers.stages[column].tries.empty()) {
        CHECK(std::ranges::find(peer_settings(), there.by, &PeerSetting::name) != peer_settings().end());
        continue;
      }
      if (there.possible() && in_a_word(there.broken) != "no end" && in_a_word(there.broken) != "crash")
        CHECK(there.starts == std::min(hard_case.starts, peer_starts));
    }
  }
  const Table table = beside_peers(read_table_csv(text_of("renders/hard_cases/table.csv")), peers);
  CHECK(peers_md(table, "renders/hard_cases") == text_of("renders/hard_cases/peers.md"));
  CHECK(draw_overview(table).width == 1600);
}

TEST_CASE("what cannot be meant, or is not built: status 2, and nothing is written") {
  const Scratch scratch;
  for (const auto& [arguments, named] :
       std::vector<std::pair<std::string, std::string>>{{"stakc", "case is 'stakc'"},
                                                        {"--stages PhysX", "stage is 'PhysX'"},
                                                        {"--stages Bulet --renew", "stage is 'Bulet'"},
                                                        {"--at-most nan", "--at-most"},
                                                        {"--jobs 0", "--jobs"},
                                                        {"slop --renew", "peers.csv"},
                                                        {"--redraw", "peers.csv"}}) {
    if (arguments == "slop --renew" && !fs::exists(fs::path(PEERS_PROGRAM).parent_path() / "motion_bullet"))
      continue;  // without engines that is what is said
    const Ended ended = call_program(PEERS_PROGRAM, "--out '" + (scratch / "out").string() + "' " + arguments);
    INFO(arguments << "\n" << ended.err);
    CHECK(ended.status == 2);
    CHECK(contains(ended.err, named));
    CHECK_FALSE(fs::exists(scratch / "out"));
  }
  const fs::path alone = scratch / "alone";  // without any engine beside it
  fs::copy_file(PEERS_PROGRAM, alone);
  const Ended ended = call_program(alone.string(), "slop --stages ODE --out '" + (scratch / "out").string() + "'");
  CHECK(ended.status == 2);
  CHECK(contains(ended.err, "its engine is missing"));
  CHECK_FALSE(fs::exists(scratch / "out"));
  CHECK(contains(call_program(PEERS_PROGRAM, "--list").out, "MuJoCo for accuracy"));
}

TEST_CASE("a program that plays is called by its name and with its case, and ended when the time is over") {
  const Scratch scratch;
  const fs::path engine = scratch / "motion_ode";
  std::ofstream(engine) << "#!/bin/sh\nsleep 20\n";
  fs::permissions(engine, fs::perms::owner_all);
  fs::copy_file(PEERS_PROGRAM, scratch / "peers");
  const Ended ended = call_program((scratch / "peers").string(),
                                   "slop --stages ODE --at-most 0.2 --out '" + (scratch / "out").string() + "'");
  INFO(ended.err);
  CHECK(ended.status == 0);
  CHECK(contains(ended.out, "no end"));
  CHECK(contains(text_of(scratch / "out/hard_cases/part/peers.csv"), "no end within 0.2 s"));
  std::ofstream(engine) << "#!/bin/sh\necho \"$*\" >&2\nexit 1\n";
  const Ended called =
      call_program((scratch / "peers").string(), "slop --stages ODE --out '" + (scratch / "out").string() + "'");
  CHECK(called.status == 0);
  CHECK(contains(text_of(scratch / "out/hard_cases/part/peers.csv"),
                 "threw: --setting ODE --hard-case slop --starts 1 --out "));
}
