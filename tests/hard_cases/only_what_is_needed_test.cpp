/// The hard cases once more, each world by what it calls for: the same outcomes, to the bit.
#include <cmath>

#include "pushback/tools/measure/hard_cases/hard_case.h"
#include "tests/support/catch.h"

using namespace pushback;

namespace {

/// All stages together play these in a few seconds,
const std::vector<std::string> quick{"heavy-1000", "row-simultaneous", "impact-500-stack", "born-deep",
                                     "slop",       "spinning-landing", "contacts-twice",   "ball-and-chain"};
/// and these in a minute.
const std::vector<std::string> others{
    "heavy-1",        "stopping-distance", "headings", "bounces",     "row-sequential",
    "there-and-back", "impact-500-free",   "dt-10",    "heavy-chain", "ragdoll"};

bool same(Real p, Real q) {
  return (p == q && std::signbit(p) == std::signbit(q)) || (std::isnan(p) && std::isnan(q));
}

/// From one start: what is compared is the way through the dispatch, not the scene.
void hold_to_direct(HardCase hard_case, const Stage& stage) {
  if (stage.name == "26 by island") return;  // it has a step of its own, which the dispatch does not compose
  hard_case.starts = 1;
  const Outcome direct = outcome_of(hard_case, stage);
  const Outcome needed = outcome_of(hard_case, only_what_is_needed(stage));
  INFO(hard_case.name << " under " << stage.name);
  REQUIRE(direct.numbers.size() == needed.numbers.size());
  for (std::size_t i = 0; i < direct.numbers.size(); ++i) {
    INFO(hard_case.criteria[i].what << ": " << direct.numbers[i] << ", " << needed.numbers[i]);
    CHECK(same(direct.numbers[i], needed.numbers[i]));
  }
  CHECK(direct.broken == needed.broken);
}

}  // namespace

TEST_CASE("hard cases by what they call for: some under all stages", "[checked]") {
  for (const std::string& name : quick) {
    for (const Stage& stage : stages()) hold_to_direct(hard_case_named(name), stage);
  }
}
TEST_CASE("hard cases by what they call for: some more under all stages", "[long]") {
  for (const std::string& name : others) {
    for (const Stage& stage : stages()) hold_to_direct(hard_case_named(name), stage);
  }
}
TEST_CASE("hard cases by what they call for: all under the full solver", "[slow]") {
  for (const HardCase& hard_case : hard_cases()) hold_to_direct(hard_case, stage_named("07 warm start"));
}
TEST_CASE("hard cases by what they call for: all under the best", "[long]") {
  for (const HardCase& hard_case : hard_cases()) hold_to_direct(hard_case, stage_named("all together"));
}
