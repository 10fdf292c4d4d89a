/// Which cases fail, under the full solver as shipped and under the best there is. The numbers of all stages are in
/// renders/hard_cases/table.md.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>

#include "pushback/chapters/25_moment_of_impact/at_impacts.h"
#include "pushback/tools/measure/hard_cases/cases.h"
#include "tests/support/call.h"

using namespace pushback;

namespace {

const std::string shipped = "07 warm start", best = "all together", of_piles = "22 wide", recommended = "26 by island";

/// None of these may be rescued or joined without being noticed.
const std::set<std::pair<std::string, std::string>> fails{
    {"stack-10", "07 warm start"},
    {"stack-20", "07 warm start"},
    {"stack-40", "07 warm start"},
    {"pyramid-20", "07 warm start"},
    {"heavy-10", "07 warm start"},
    {"heavy-100", "07 warm start"},
    {"heavy-1000", "07 warm start"},
    {"densities-1-1-100", "07 warm start"},
    {"jenga-30", "07 warm start"},
    {"brick-wall", "07 warm start"},
    {"plank-tower", "07 warm start"},
    {"arch", "07 warm start"},
    {"slopes", "all together"},
    {"slopes", "22 wide"},
    {"headings", "07 warm start"},
    {"four-balls", "07 warm start"},
    {"bounces", "07 warm start"},
    {"elastic-49", "07 warm start"},
    {"row-sequential", "07 warm start"},
    {"row-sequential", "all together"},
    {"row-sequential", "22 wide"},
    {"row-simultaneous", "07 warm start"},
    {"row-simultaneous", "26 by island"},
    {"born-deep", "07 warm start"},
    {"slop", "all together"},
    {"slop", "22 wide"},
    {"slop", "26 by island"},
    {"bullet", "07 warm start"},
    {"bullet", "all together"},
    {"spinning-rod", "07 warm start"},
    {"spinning-rod", "22 wide"},
    {"turntable", "07 warm start"},
    {"turntable", "all together"},
    {"turntable", "22 wide"},
    {"turntable", "26 by island"},
    {"groove", "07 warm start"},
    {"peg", "07 warm start"},
    {"two-balls", "07 warm start"},
    {"painleve", "all together"},
    {"painleve", "22 wide"},
    {"squeezed", "07 warm start"},
    {"squeezed", "all together"},
    {"tiny-50mm", "07 warm start"},
    {"tiny-5mm", "07 warm start"},
    {"dt-10", "07 warm start"},
    {"dt-30", "07 warm start"},
    {"dt-60", "07 warm start"},
    {"dt-changing", "07 warm start"},
    {"dt-changing", "all together"},
    {"any-order", "07 warm start"},
    {"heavy-chain", "07 warm start"},
    {"ball-and-chain", "07 warm start"},
    {"bridge", "07 warm start"},
    {"ragdoll", "07 warm start"},
    {"ragdoll", "all together"},
    {"ragdoll", "22 wide"},
    {"ragdoll", "26 by island"},
    {"basketball", "07 warm start"},
    {"tan-theta", "07 warm start"},
    {"milankovitch", "07 warm start"},
    {"four-bar", "07 warm start"},
};

/// What takes `best` longer than the rest: ./course check plays it.
const std::vector<std::string> slow{"stack-40", "plank-tower", "rubble", "any-order"};
/// And what takes it longest: always labelled long.
const std::vector<std::string> slowest{"pyramid-20", "jenga-30", "brick-wall", "tan-theta"};

/// Of the starts of the cases at a knife's edge, here; all of them are played for the table, and by the long test below.
constexpr int tested_starts = 2;

[[maybe_unused]] void hold_to_the_list(HardCase hard_case, const std::string& stage, int most_starts = tested_starts) {
  hard_case.starts = std::min(hard_case.starts, most_starts);
  const Outcome outcome = outcome_of(hard_case, stage_named(stage));
  REQUIRE(outcome.numbers.size() == hard_case.criteria.size());
  INFO(hard_case.name << " under " << stage << (outcome.broken.empty() ? "" : ": " + outcome.broken));
  for (std::size_t i = 0; i < outcome.numbers.size(); ++i) {
    UNSCOPED_INFO(hard_case.criteria[i].what << " " << outcome.numbers[i] << " " << hard_case.criteria[i].unit
                                             << ", limit " << hard_case.criteria[i].limit);
  }
  CHECK(outcome.passed(hard_case) != fails.contains({hard_case.name, stage}));
}

[[maybe_unused]] void hold_to_the_list(const std::vector<HardCase>& group) {
  for (const HardCase& hard_case : group) {
    hold_to_the_list(hard_case, shipped);
    const auto is_this = [&](const std::string& name) { return name == hard_case.name; };
    if (std::any_of(slow.begin(), slow.end(), is_this) || std::any_of(slowest.begin(), slowest.end(), is_this))
      continue;
    hold_to_the_list(hard_case, best);
  }
}

}  // namespace

#ifndef PUSHBACK_FLOAT  // the list is that of the shipped build
TEST_CASE("hard cases: stacks", "[slow]") {
  hold_to_the_list(stack_cases());
}
TEST_CASE("hard cases: piles") {
  hold_to_the_list(pile_cases());
}
TEST_CASE("hard cases: stones", "[slow]") {
  hold_to_the_list(stone_cases());
}
TEST_CASE("hard cases: friction") {
  hold_to_the_list(friction_cases());
}
TEST_CASE("hard cases: bounces") {
  hold_to_the_list(bounce_cases());
}
TEST_CASE("hard cases: impacts") {
  hold_to_the_list(impact_cases());
}
TEST_CASE("hard cases: scales", "[slow]") {
  hold_to_the_list(scale_cases());
}
TEST_CASE("hard cases: steps", "[slow]") {
  hold_to_the_list(step_cases());
}
TEST_CASE("hard cases: joints", "[slow]") {
  hold_to_the_list(joint_cases());
}
TEST_CASE("hard cases: balls") {
  hold_to_the_list(ball_cases());
}
TEST_CASE("hard cases: edges") {
  hold_to_the_list(edge_cases());
}
TEST_CASE("hard cases: mechanisms") {
  hold_to_the_list(mechanism_cases());
}
TEST_CASE("hard cases: a solver that holds no joints says so, and the case counts as failed") {
  for (const auto& group : {joint_cases(), mechanism_cases()}) {
    for (const HardCase& hard_case : group) {
      const Outcome outcome = outcome_of(hard_case, stage_named("00 naive"));
      CHECK_FALSE(outcome.passed(hard_case));
      CHECK(outcome.broken.find("this solver holds no joints") != std::string::npos);
      for (const Real number : outcome.numbers) CHECK(std::isnan(number));
    }
  }
}
TEST_CASE("hard cases: all contacts solved directly, each case from one start") {
  const Stage& direct = stage_named("19 direct contacts");
  for (const char* name : {"stack-20", "heavy-100", "heavy-1000", "slopes", "dt-changing", "painleve"}) {
    const HardCase& hard_case = hard_case_named(name);
    const Outcome outcome = outcome_of(hard_case, direct);
    INFO(name << " " << outcome.broken);
    CHECK(outcome.starts == 1);
    CHECK(outcome.passed(hard_case));
  }
}
TEST_CASE("hard cases: where steps are cut at impacts, a bullet and a spinning rod pass, and nothing gets through") {
  Stage cut{{"25", "chapter 25's step", AtImpacts{}, {}}};
  cut.half_steps = true;
  for (const char* name : {"bullet", "spinning-rod"}) {
    const HardCase& hard_case = hard_case_named(name);
    const Outcome outcome = outcome_of(hard_case, cut);
    INFO(name << " " << outcome.broken);
    CHECK(outcome.passed(hard_case));
    CHECK(outcome_of(hard_case, stage_named(shipped)).numbers[0] > 50);                               // mm
    CHECK(outcome.numbers[0] == Approx(0).margin(1e-5));                                              // mm
    for (std::size_t i = 1; i < outcome.numbers.size(); ++i) CHECK(outcome.numbers[i] < Real(0.02));  // %
  }
}
TEST_CASE("hard cases: the slow ones under the best solver", "[checked]") {
  for (const std::string& name : slow) hold_to_the_list(hard_case_named(name), best);
}
TEST_CASE("hard cases: the slowest ones under the best solver", "[long]") {
  for (const std::string& name : slowest) hold_to_the_list(hard_case_named(name), best);
}
TEST_CASE("hard cases: those at a knife's edge from all starts", "[long]") {
  for (const HardCase& hard_case : hard_cases()) {
    if (hard_case.starts == 1) continue;
    for (const std::string& stage : {shipped, best}) hold_to_the_list(hard_case, stage, many_starts);
  }
}
TEST_CASE("hard cases: what cannot be solved") {
  hold_to_the_list(no_solution_cases());
}
TEST_CASE("hard cases: what is recommended", "[long]") {
  for (const HardCase& hard_case : hard_cases())
    for (const std::string& stage : {of_piles, recommended}) hold_to_the_list(hard_case, stage);
}
TEST_CASE("hard cases: the written table fails where the list says, from all starts") {
  std::set<std::pair<std::string, std::string>> written;
  std::ifstream csv("renders/hard_cases/table.csv");
  std::string line;
  for (std::getline(csv, line); std::getline(csv, line);) {
    const std::vector<std::string> fields = fields_of(line);
    REQUIRE(fields.size() == 11);
    if (fields[1] != shipped && fields[1] != best && fields[1] != of_piles && fields[1] != recommended) continue;
    if (fields[6] == "0" || !fields[7].empty()) written.emplace(fields[0], fields[1]);
  }
  CHECK(written == fails);
}
#endif

TEST_CASE("hard cases: contacts given twice are corrected like contacts given once") {
  const HardCase& twice = hard_case_named("contacts-twice");
  CHECK(outcome_of(twice, stage_named("10 split impulse")).largest[0] < Real(1e-3));  // mm; without, the slop's 5 mm
}
