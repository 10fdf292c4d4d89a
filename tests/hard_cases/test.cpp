/// Which cases fail, under the full solver as shipped and under the best there is: those that fail in the committed table,
/// renders/hard_cases/table.csv. None may be rescued or joined without being noticed.
#include <algorithm>
#include <cmath>

#include "pushback/common/basics/files.h"
#include "pushback/tools/measure/hard_cases/table.h"
#include "tests/support/catch.h"

using namespace pushback;

namespace {

const std::string shipped = "07 warm start", best = "all together", of_piles = "22 wide", recommended = "26 by island";

/// What takes `best` longer than the rest: ./course check plays it.
const std::vector<std::string> slow{"stack-40", "plank-tower", "rubble", "any-order"};
/// And what takes it longest: always labelled long.
const std::vector<std::string> slowest{"pyramid-20", "jenga-30", "brick-wall", "tan-theta"};

/// Of the starts of the cases at a knife's edge, here; all of them are played for the table, and by the long test below.
constexpr int tested_starts = 2;

const Table& committed() {
  static const Table table = read_table_csv(read_text_file("renders/hard_cases/table.csv"));
  return table;
}

[[maybe_unused]] void hold_to_the_table(HardCase hard_case, const std::string& stage, int most_starts = tested_starts) {
  hard_case.starts = std::min(hard_case.starts, most_starts);
  const Outcome outcome = outcome_of(hard_case, stage_named(stage));
  REQUIRE(outcome.numbers.size() == hard_case.criteria.size());
  INFO(hard_case.name << " under " << stage << (outcome.broken.empty() ? "" : ": " + outcome.broken));
  for (std::size_t i = 0; i < outcome.numbers.size(); ++i)
    UNSCOPED_INFO(hard_case.criteria[i].what << " " << outcome.numbers[i] << ", limit "
                                             << hard_case.criteria[i].limit_with_unit());
  const Outcome* const there = committed().find(hard_case.name, stage);
  REQUIRE(there != nullptr);
  CHECK(outcome.passed(hard_case) == there->passed(hard_case));
}

[[maybe_unused]] void hold_to_the_table(const std::vector<HardCase>& group) {
  for (const HardCase& hard_case : group) {
    hold_to_the_table(hard_case, shipped);
    const auto is_among = [&](const std::vector<std::string>& names) {
      return std::ranges::count(names, hard_case.name);
    };
    if (!is_among(slow) && !is_among(slowest)) hold_to_the_table(hard_case, best);
  }
}

}  // namespace

#ifndef PUSHBACK_FLOAT  // the table is that of the shipped build
TEST_CASE("hard cases: stacks", "[slow]") {
  hold_to_the_table(stack_cases());
}
TEST_CASE("hard cases: piles") {
  hold_to_the_table(pile_cases());
}
TEST_CASE("hard cases: stones", "[slow]") {
  hold_to_the_table(stone_cases());
}
TEST_CASE("hard cases: friction, and what is guided") {
  hold_to_the_table(friction_cases());
  hold_to_the_table(guided_cases());
}
TEST_CASE("hard cases: bounces and impacts") {
  for (const auto& group : {bounce_cases(), impact_cases(), ball_cases()}) hold_to_the_table(group);
  for (const char* name : {"bullet", "spinning-rod"}) hold_to_the_table(hard_case_named(name), recommended);
}
TEST_CASE("hard cases: scales", "[slow]") {
  hold_to_the_table(scale_cases());
}
TEST_CASE("hard cases: steps, and contacts given twice, which are corrected like those given once", "[slow]") {
  hold_to_the_table(step_cases());
  hold_to_the_table(hard_case_named("contacts-twice"), "10 split impulse");
}
TEST_CASE("hard cases: joints", "[slow]") {
  hold_to_the_table(joint_cases());
  hold_to_the_table(mechanism_cases());
}
TEST_CASE("hard cases: what cannot be solved, and the edges of what can") {
  hold_to_the_table(no_solution_cases());
  hold_to_the_table(edge_cases());
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
TEST_CASE("hard cases: all contacts solved directly") {
  for (const char* name : {"stack-20", "heavy-100", "heavy-1000", "slopes", "dt-changing", "painleve"})
    hold_to_the_table(hard_case_named(name), "19 direct contacts");
}
TEST_CASE("hard cases: the slow ones under the best solver", "[checked]") {
  for (const std::string& name : slow) hold_to_the_table(hard_case_named(name), best);
}
TEST_CASE("hard cases: the slowest ones under the best solver", "[long]") {
  for (const std::string& name : slowest) hold_to_the_table(hard_case_named(name), best);
}
TEST_CASE("hard cases: those at a knife's edge from all starts", "[long]") {
  for (const HardCase& hard_case : hard_cases()) {
    if (hard_case.starts == 1) continue;
    for (const std::string& stage : {shipped, best}) hold_to_the_table(hard_case, stage, many_starts);
  }
}
TEST_CASE("hard cases: what is recommended", "[long]") {
  for (const HardCase& hard_case : hard_cases())
    for (const std::string& stage : {of_piles, recommended}) hold_to_the_table(hard_case, stage);
}
#endif
