/// The table of hard cases: its words, its files, and the program that writes it.
#include "pushback/tools/measure/hard_cases/table.h"

#include <algorithm>
#include <limits>
#include <set>

#include "tests/support/call.h"
#include "tests/support/complaint.h"

#ifndef TABLE_PROGRAM
#define TABLE_PROGRAM "build/release/programs/hard_cases_table"
#endif

using namespace pushback;

namespace {

constexpr Real not_a_number = std::numeric_limits<Real>::quiet_NaN();

/// Its steps do nothing; where `spoils` says so, they leave what is no number.
struct Idle : StepSolver {
  std::function<bool()> spoils;
  void solve(World& world, Real, int) override {
    if (spoils()) world.bodies.back().velocity.y() = not_a_number;
  }
};
Stage a_stage(const std::function<bool()>& spoils) {
  Idle idle;
  idle.spoils = spoils;
  return {{.name = "stage", .what = "", .solver = idle, .fitting = {}}};
}

/// A row of `marks`, P for a pass, under as many stages, of which the first `chapters` are chapters.
Table row_of(const std::string& marks, std::size_t chapters) {
  Table table;
  table.cases.resize(1);
  table.cases[0].criteria = {{"drift", "mm", 1}};
  table.chapters = chapters;
  for (const char mark : marks) {
    table.stages.push_back(a_stage([] { return false; }));
    table.outcomes.push_back({{mark == 'P' ? Real(0.5) : Real(2)}, "", 0});
  }
  return table;
}

std::set<std::string> files_in(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) names.insert(entry.path().filename().string());
  }
  return names;
}

}  // namespace

TEST_CASE("what is no number fails, and so does a case whose invariant broke") {
  Table table = row_of("PP", 2);
  table.outcomes[0].numbers[0] = table.outcomes[0].largest[0] = not_a_number;
  table.outcomes[1].broken = "157 J gained after 0.1 s, \"at once\"";
  table.cases[0].name = "case";
  CHECK_FALSE(table.passed(0, 0));
  CHECK_FALSE(table.passed(0, 1));
  CHECK(table_csv(table) ==
        "case,stage,criterion,unit,limit,number,pass,broken,largest,starts_passed,starts\n"
        "case,stage,drift,mm,1,nan,0,,nan,0,1\n"
        "case,stage,drift,mm,1,0.5,1,\"157 J gained after 0.1 s, \"\"at once\"\"\",0.5,0,1\n");
  CHECK(contains(table_md(table, "renders/hard_cases"), "| ✗ – | ✗ 0.5 mm<br>energy |"));
}

TEST_CASE(
    "from several starts: the largest number counts, one start that fails is enough, and the first that breaks is "
    "named") {
  HardCase c;
  c.criteria = {{"height", "m", 1}, {"way", "m", 1}};
  c.starts = 4;
  std::vector<std::vector<Real>> plays{{Real(0.5), Real(0.1)}, {Real(0.25), 3}, {Real(0.75), 0}, {Real(0.125), 0}};
  std::vector<Vec3> begun;
  const Stage any = a_stage([&begun] { return begun.size() == 3; });
  c.run = [&](Trial& trial) {
    Play play = trial.play([](World& world) {
      world.add(ground());
      world.add(sphere(1, 1));
    });
    CHECK(play.world.bodies[0].position == Vec3::Zero());
    begun.push_back(play.world.bodies[1].position);
    if (begun.size() == 3) play.step();
    return plays[begun.size() - 1];
  };
  const Outcome outcome = outcome_of(c, any);
  CHECK(outcome.numbers == plays[0]);
  CHECK(std::isnan(outcome.largest[0]));  // of the third
  CHECK(outcome.broken.find("start 3: not finite") == 0);
  CHECK(outcome.starts_passed == 2);
  CHECK_FALSE(outcome.passed(c));
  CHECK(passed_of_starts(outcome) == "2/4");
  CHECK(begun[0] == Vec3::Zero());
  for (std::size_t i = 1; i < begun.size(); ++i) {
    CHECK(begun[i] != begun[i - 1]);
    CHECK(begun[i].cwiseAbs().minCoeff() > 0);
    CHECK(begun[i].cwiseAbs().maxCoeff() <= nudge);
  }

  begun.clear();
  c.starts = 2;  // one start that fails is enough
  const Outcome both = outcome_of(c, any);
  CHECK(both.largest == std::vector<Real>{Real(0.5), 3});
  CHECK(both.broken.empty());
  CHECK_FALSE(both.passed(c));
  CHECK(both.worst(c) == 1);
}

TEST_CASE("some cases and stages: files of their own, the same bytes whatever the number of threads", "[slow]") {
  const Scratch scratch;
  // The last stage takes so long that with two threads the pairs are finished in another order.
  const std::string what = "stack-10 stack-20 --stages 01,07,soft --starts 2 --out '";
  const Ended one = call_program(TABLE_PROGRAM, "--jobs 1 " + what + (scratch / "one").string() + "'", 100);
  const Ended two = call_program(TABLE_PROGRAM, "--jobs 2 " + what + (scratch / "two").string() + "'", 100);
  INFO(one.err << two.err);
  REQUIRE(one.status == 0);
  REQUIRE(two.status == 0);
  const fs::path folder = scratch / "one" / "hard_cases" / "part", other = scratch / "two" / "hard_cases" / "part";
  CHECK(files_in(scratch / "one") == std::set<std::string>{"overview.png", "table.csv", "table.md", "times.csv"});
  for (const std::string file : {"overview.png", "table.csv", "table.md"}) {
    INFO(file);
    CHECK(text_of(folder / file).size() > 100);
    CHECK(text_of(folder / file) == text_of(other / file));
  }
}

TEST_CASE("the committed table is read back to the byte, its page is what it makes, and what is no table is refused") {
  const std::string csv = text_of("renders/hard_cases/table.csv");
  const Table table = read_table_csv(csv);
  CHECK(table.cases.size() == hard_cases().size());
  CHECK(table.stages.size() == table_stages().size());
  CHECK(table.chapters == chapter_stages);
  CHECK(table_csv(table) == csv);
  const std::string page = table_md(table, "renders/hard_cases");
  CHECK(page == text_of("renders/hard_cases/table.md"));
  CHECK(contains(page, "(../../chapters/07_warm_start/README.md)"));
  const Image overview = draw_overview(table);
  CHECK(overview.width == 1600);
  CHECK(overview.height < 2800);

  const std::string head = csv.substr(0, csv.find('\n') + 1);
  const std::string line = csv.substr(head.size(), csv.find('\n', head.size()) + 1 - head.size());
  for (const auto& [text, named] : std::vector<std::pair<std::string, std::string>>{
           {"", "no lines of cases"},
           {head, "no lines of cases"},
           {head + "stack-10,00 naive\n", "line 2 has 2 fields"},
           {head + "no-such" + line.substr(line.find(',')), "no-such"},
           {head + "stack-10,no such stage,a,b,1,0,0,,0,0,30\n", "no such stage"},
           {head + line, "line 3 should be of stack-10, 00 naive"},
           {csv.substr(0, csv.rfind('\n', csv.size() - 2) + 1), "should be of motor-at-limit, 19 direct contacts"},
           {csv + line, "should be of stack-10"},
           {csv + csv.substr(csv.rfind('\n', csv.size() - 2) + 1), "lines were expected"},
           {head + "stack-10,00 naive,drift after 10 s,mm,one,0,0,,0,0,30\n", "'one' where a number"},
       }) {
    INFO(named);
    CHECK(contains(complaint([&text = text] { read_table_csv(text); }), named));
  }
  const Scratch scratch;
  const Ended none = call_program(TABLE_PROGRAM, "--redraw --out '" + (scratch / "none").string() + "'");
  CHECK(none.status == 2);
  CHECK(contains(none.err, "table.csv"));
  CHECK(!fs::exists(scratch / "none"));
}

TEST_CASE("random scenes: one that was known to fail and does not is a failure, whatever the number of threads") {
  const std::string what = "--first 5 --scenes 3 --stage '07 warm start' --known 6 --jobs ";
  const Ended one = call_program(FUZZ_PROGRAM, what + "1", 100), two = call_program(FUZZ_PROGRAM, what + "2", 100);
  CHECK(one.status == 1);
  CHECK(contains(one.out, "scene 6, 07 warm start: known to fail, and did not\n"));
  CHECK(contains(one.err, "1 of 3 runs"));
  CHECK(two.out == one.out);
}

TEST_CASE("what cannot be meant: status 2, a message that names it, and nothing is written") {
  struct Wrong {
    std::string arguments;
    std::vector<std::string> named;
  };
  for (const Wrong& wrong : std::vector<Wrong>{
           {"stak-20", {"case is 'stak-20': one of these is needed: stack-10"}},
           {"stack-10 ''", {"an argument: '' is not allowed"}},
           {"--stages frction", {"stage is 'frction'", "07 warm start"}},
           {"--stages 07,banana", {"stage is 'banana'"}},
           {"--quick --stages soft", {"stage is 'soft'"}},
           {"--jobs 0", {"--jobs", "'0' is not allowed"}},
           {"--jobs many", {"--jobs", "many"}},
           {"--starts 31", {"--starts", "'31' is not allowed", "30"}},
           {"--banana", {"--banana"}},
       }) {
    const Scratch scratch;
    const Ended ended = call_program(TABLE_PROGRAM, "--out '" + (scratch / "out").string() + "' " + wrong.arguments);
    INFO(wrong.arguments << "\n" << ended.err);
    CHECK(ended.status == 2);
    for (const std::string& name : wrong.named) CHECK(contains(ended.err, name));
    CHECK(ended.out.empty());
    CHECK_FALSE(fs::exists(scratch / "out"));
  }
  const Scratch scratch;
  std::ofstream(scratch / "file") << "no folder";
  const Ended ended = call_program(TABLE_PROGRAM, "stack-10 --stages 00 --out '" + (scratch / "file").string() + "'");
  CHECK(ended.status == 2);
  CHECK(contains(ended.err, "--out: folder"));
}
