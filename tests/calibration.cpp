/// The first of the scenes of ./course run calibration: whether what Recommended says of its error is true.
#include "pushback/tools/measure/calibration/calibration.h"
#include "pushback/common/basics/files.h"
#include "tests/support/catch.h"

using namespace pushback;
using namespace pushback::calibration;

namespace {

std::vector<Truth> first_truths(std::size_t count) {
  std::vector<Truth> truths = truths_in(read_text_file(PUSHBACK_TRUTHS "/work.csv"));
  truths.resize(count);
  return truths;
}

}  // namespace

TEST_CASE(
    "calibration: of 600 drawn scenes, few are flagged, and hardly any error is larger than what is asked and said",
    "[slow]") {
  int known = 0, flagged = 0, missed = 0, covered = 0;
  for (const Truth& truth : first_truths(600)) {
    const Scene drawn = scene(truth.number);
    if (!truth.good_for(drawn.asked)) continue;
    const Played played = play(drawn, truth);
    ++known;
    flagged += played.flagged;
    missed += played.missed();
    covered += played.covered();
  }
  INFO(known << " with a truth: " << flagged << " flagged, " << missed << " missed, " << covered << " covered");
  CHECK(known >= 300);
  CHECK(flagged <= known / 4);
  CHECK(missed <= known / 100);
  CHECK(covered >= known * 95 / 100);
}

TEST_CASE("calibration: a scene depends on its number only, and stored truths are those that are found") {
  const std::vector<Truth> truths = first_truths(60);
  for (const std::size_t i : {9, 12, 16}) {
    const Truth again = find_truth(truths[i].number);
    REQUIRE(again.places.size() == truths[i].places.size());
    for (std::size_t body = 0; body < again.places.size(); ++body)
      CHECK((again.places[body] - truths[i].places[body]).norm() < Real(1e-9));
  }
  CHECK(truths_in(text_of(truths)).size() == truths.size());
}
