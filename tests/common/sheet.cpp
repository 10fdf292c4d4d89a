// The comparison sheet: its measures, its files, one colour for one name.
#include "pushback/common/experiment/sheet.h"

#include "pushback/common/experiment/experiment.h"
#include "pushback/common/experiment/marker.h"
#include "tests/support/call.h"
#include "tests/support/catch.h"

using namespace pushback;

namespace {

constexpr Ink red{200, 10, 20}, green{10, 160, 30}, blue{20, 30, 220};

Image filled(int wide, int height, Ink ink) {
  Image image(wide, height);
  fill_rectangle(image, 0, 0, wide, height, ink);
  return image;
}
bool is(const Image& image, int x, int y, Ink ink) {
  const std::uint8_t* at = image.at(x, y);
  return at[0] == ink.red && at[1] == ink.green && at[2] == ink.blue;
}
/// The runs of one colour along a line of the image: where each begins and how long it is.
std::vector<std::pair<int, int>> runs(const Image& image, int y, Ink ink) {
  std::vector<std::pair<int, int>> found;
  for (int x = 0; x < image.width; ++x) {
    if (!is(image, x, y, ink)) continue;
    if (!found.empty() && found.back().first + found.back().second == x) ++found.back().second;
    else found.emplace_back(x, 1);
  }
  return found;
}
/// The first line below `y` that has as many pixels of the colour as that.
int line_with(const Image& image, int y, Ink ink, int least) {
  for (; y < image.height; ++y) {
    int count = 0;
    for (int x = 0; x < image.width; ++x) count += is(image, x, y, ink) ? 1 : 0;
    if (count >= least) return y;
  }
  return -1;
}

Sheet sheet_of(int rows) {
  Sheet sheet{.question = "Does it stand?",
              .scene = "a stack",
              .caption = "Look at the top.",
              .foot = "",
              .start = filled(500, 281, blue),
              .legend = {},
              .raster = {},
              .wide = false,
              .rows = {}};
  for (int i = 0; i < rows; ++i) {
    sheet.rows.push_back({marker_of(static_cast<std::size_t>(i)), "warm", green, {}, {}, {}, {}});
    sheet.rows.back().cells.assign(3, filled(500, 281, red));
    sheet.rows.back().cell_notes.assign(3, "t = 1 s");
  }
  return sheet;
}

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

TEST_CASE("a sheet is 1600 wide, and its cells stand on it three in a row, pixel by pixel") {
  for (const int rows : {1, 4}) {
    const Image image = make_sheet(sheet_of(rows));
    CHECK(image.width == 1600);
    CHECK(image.height < 365 * rows + 380);
    const int start = line_with(image, 0, blue, 500);
    REQUIRE(start >= 0);
    CHECK(runs(image, start, blue) == std::vector<std::pair<int, int>>{{1060, 500}});
    int y = 0;
    for (int row = 0; row < rows; ++row) {
      y = line_with(image, y, red, 1500);
      REQUIRE(y > start + 280);
      CHECK(runs(image, y, red) == std::vector<std::pair<int, int>>{{40, 500}, {550, 500}, {1060, 500}});
      CHECK(runs(image, y + 280, red).size() == 3);
      CHECK(runs(image, y + 281, red).empty());
      y += 281;
    }
    CHECK(line_with(image, y, red, 1500) == -1);
  }
}

TEST_CASE("a label begins at its point, and a scale bar is as long as the displacement it names is drawn") {
  Scene scene;
  scene.camera = {{0, 0, 10}, {0, 0, 0}, 2 * std::atan(Real(0.1))};  // sees 2 m from top to bottom
  scene.labels = {{Vec3(1, Real(0.5), 0), "a corner"}};
  scene.magnified = 100;
  const std::vector<SheetLabel> labels = labels_of(scene, 2);
  REQUIRE(labels.size() == 2);
  CHECK(labels[0].text == "a corner");
  CHECK(labels[0].x == Approx(0.75));
  CHECK(labels[0].y == Approx(0.25));
  CHECK(labels[0].bar == 0);
  CHECK(labels[1].text == "2 mm");
  CHECK(labels[1].bar == Approx(100 * 0.002 / 4));
  scene.magnified = 1;
  CHECK(labels_of(scene, 2).size() == 1);
}

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
