// The comparison sheet: its files, and one marker for one name.
#include "pushback/common/experiment/sheet.h"

#include "pushback/common/experiment/experiment.h"
#include "tests/support/call.h"
#include "tests/support/catch.h"

using namespace pushback;

namespace {

/// Two scenes that share the name of a variant, and a third without pictures.
int run(std::vector<const char*> arguments, const std::string& second_key = "tower") {
  arguments.insert(arguments.begin(), "shared_names");
  Experiment e("shared_names", "Is one name one colour?");
  return e.run(static_cast<int>(arguments.size()), arguments.data(), [&] {
    const auto still = [](World&, Real, int) -> std::size_t { return 0; };
    const auto fill = [](World& world) { world.add(sphere(1, 1)); };
    e.scene({.name = "a ball", .fill = fill, .instants = {0, Real(0.1)}});
    e.motion("cold", still);
    e.motion("warm", still);
    e.scene({.name = "a tower", .fill = fill, .key = second_key});
    e.motion("hot", still);
    e.motion("warm", still);
    e.scene({.name = "numbers alone", .fill = fill, .pictures = false});
    e.motion("green", still).coloured(0);
    e.motion("hot", still);
    e.number("bodies", "", [](const Run& all) { return static_cast<Real>(all.world.bodies.size()); });
  });
}

}  // namespace

TEST_CASE("one name has one marker in all scenes, whichever variants are run") {
  const Scratch scratch;
  const std::string out = (scratch / "").string();
  REQUIRE(run({"--no-images", "--out", out.c_str()}) == 0);
  const std::string table = text_of(scratch / "shared_names/numbers.md");
  INFO(table);
  CHECK(contains(table, "| ■ cold |"));  // ● was given to green
  std::size_t count = 0;
  for (std::size_t at = table.find("| ▲ warm |"); at != std::string::npos; at = table.find("| ▲ warm |", at + 1))
    ++count;
  CHECK(count == 2);
  count = 0;
  for (std::size_t at = table.find("| ◆ hot |"); at != std::string::npos; at = table.find("| ◆ hot |", at + 1)) ++count;
  CHECK(count == 2);
  CHECK(contains(table, "| ● green | 1 |"));
  REQUIRE(run({"--no-images", "--out", out.c_str(), "--variants", "hot"}) == 0);
  CHECK(contains(text_of(scratch / "shared_names/numbers.md"), "| ◆ hot |"));
}

TEST_CASE("a sheet for each scene that has pictures, and no frames unless asked for") {
  const Scratch scratch;
  const std::string out = (scratch / "").string();
  const fs::path folder = scratch / "shared_names";
  REQUIRE(run({"--size", "64x36", "--out", out.c_str()}, "pile") == 0);
  CHECK(fs::exists(folder / "sheet_pile.png"));
  REQUIRE(run({"--size", "64x36", "--out", out.c_str()}) == 0);
  std::set<std::string> files;
  for (const auto& entry : fs::directory_iterator(folder)) files.insert(entry.path().filename().string());
  CHECK(files == std::set<std::string>{"sheet.png", "sheet_tower.png", "thumbnail.png", "start.png", "plot.png",
                                       "metrics.csv", "numbers.md"});
  for (const char* file : {"sheet.png", "sheet_tower.png"}) CHECK(read_png(folder / file).width == 1600);
  REQUIRE(run({"--size", "64x36", "--frames", "2", "--out", out.c_str()}) == 0);
  CHECK(fs::exists(folder / "a-ball_warm" / "frame_0001.png"));
  CHECK_FALSE(fs::exists(folder / "a-ball_warm" / "frame_0002.png"));
}

TEST_CASE("two scenes of one key are refused") {
  const Scratch scratch;
  const std::string out = (scratch / "nothing").string();
  CHECK(run({"--no-images", "--out", out.c_str()}, "a ball") == 2);
  CHECK_FALSE(fs::exists(scratch / "nothing"));
}
