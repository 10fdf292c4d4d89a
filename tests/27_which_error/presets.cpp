/// Fast, Recommended, Exact: each is more exact than the one before.
#include "pushback/chapters/27_which_error/presets.h"
#include "pushback/chapters/19_accuracy_and_time/true_places.h"
#include "tests/support/catch.h"

using namespace pushback;

namespace {

/// mm.
template <class Preset>
Real largest_error(const Motion& motion, const TruePlaces& truth) {
  World world;
  motion.begin(world);
  Preset solver;
  Real largest = 0;
  for (int frame = 0; frame < motion.frames(); ++frame) {
    world.step(solver, Real(1) / frames_per_second);
    largest = std::max(largest, truth.error(world));
  }
  return largest;
}

}  // namespace

TEST_CASE("presets: the page's lines") {
  World world;  // bodies are added as on the front page
  Recommended solver;
  world.step(solver, 1.0 / 60);
  CHECK(world.time > 0);
}

TEST_CASE("presets: the errors of each are smaller than those of the one before, or rounding") {
  constexpr Real rounding = Real(1e-6);  // mm
  for (const std::string name : {"bounce", "incline", "sliding", "pendulum", "stack-10", "heavy-on-light", "chain"}) {
    INFO(name);
    const Motion& motion = motion_named(name);
    const TruePlaces truth(motion);
    const Real fast = largest_error<Fast>(motion, truth), recommended = largest_error<Recommended>(motion, truth),
               exact = largest_error<Exact>(motion, truth);
    CHECK(recommended < fast / 4);
    CHECK((exact < recommended / 4 || exact < rounding));
  }
}
