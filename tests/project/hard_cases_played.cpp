/// What the book plays where a cell is opened is what the table has measured.
#include "pushback/common/live/live.h"
#include "pushback/tools/measure/hard_cases/table.h"
#include "tests/support/catch.h"

using namespace pushback;

TEST_CASE("each case under each stage moves in the bits of the table's first start, or is refused in both") {
  Experiment experiment("hard_cases", "?");
  Live live(experiment, [&] { describe_hard_cases(experiment); });
  std::size_t refused = 0;
  for (std::size_t c = 0; c < hard_cases().size(); ++c) {
    for (std::size_t s = 0; s < stages().size(); ++s) {
      INFO(hard_cases()[c].name << ", " << stages()[s].name);
      live.choose(c, {s});
      REQUIRE(live.tracks() == 1);
      REQUIRE(live.variant(0) == s);
      constexpr int steps = 8;
      live.go_to(steps);
      Trial trial(stages()[s]);
      Play play = trial.play(hard_cases()[c].scene.fill);
      for (int i = 0; i < steps; ++i) play.step();
      REQUIRE(live.mishap(0).empty() == play.sound());
      if (play.sound()) CHECK(hash_of(live.world(0)) == hash_of(play.world));
      else ++refused;
    }
  }
  CHECK(refused == 6);  // the naive one holds no joints: two chains, a bridge, a ragdoll, a linkage, a door
}
