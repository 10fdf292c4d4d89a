/// Fast, Recommended, Exact: each is more exact than the one before.
#include "pushback/engine/presets.h"
#include "pushback/chapters/24_half_step/study.h"
#include "tests/support/catch.h"

using namespace pushback;

TEST_CASE("presets: the page's lines") {
  World world;  // bodies are added as on the front page
  Recommended solver;
  world.step(solver, 1.0 / 60);
  CHECK(world.time > 0);
}

TEST_CASE("presets: the errors of each are smaller than those of the one before, or rounding") {
  constexpr Real rounding = Real(1e-9);  // m
  for (const std::string name : {"bounce", "incline", "sliding", "pendulum", "stack-10", "heavy-on-light", "chain"}) {
    INFO(name);
    const Motion& motion = motion_named(name);
    const std::vector<Places> truth = motion.truth(motion.frames());
    const auto error = [&](const AnySolver& preset) { return half_step_scenes::largest_error(motion, truth, preset); };
    const Real fast = error(Fast{}), recommended = error(Recommended{}), exact = error(Exact{});
    CHECK(recommended < fast / 4);
    CHECK((exact < recommended / 4 || exact < rounding));
  }
}
