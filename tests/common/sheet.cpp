// The comparison sheet: its measures, its files, one colour for one name.
#include "pushback/common/experiment/sheet.h"

#include <array>

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

TEST_CASE("variants with a single picture each stand beside each other") {
  Sheet sheet = sheet_of(3);
  const std::array inks{red, green, blue};
  sheet.start.reset();
  for (std::size_t i = 0; i < 3; ++i) sheet.rows[i].cells.assign(1, filled(500, 400, inks[i]));
  sheet.rows[1].numbers.assign(4, {"overlap: 1 mm", "should be 0 mm"});  // the highest label moves all pictures down
  const Image image = make_sheet(sheet);
  CHECK(image.width == 1600);
  const int y = line_with(image, 0, red, 500);
  REQUIRE(y > 0);
  for (int c = 0; c < 3; ++c) {
    const Ink ink = inks[static_cast<std::size_t>(c)];
    CHECK(runs(image, y, ink) == std::vector<std::pair<int, int>>{{40 + 510 * c, 500}});
    CHECK(is(image, 40 + 510 * c, y + 399, ink));
  }
  CHECK(runs(image, y + 400, red).empty());
}

TEST_CASE("beside two variants stands the start, at the left, since time goes to the right") {
  Sheet sheet = sheet_of(2);
  for (SheetRow& row : sheet.rows) row.cells.resize(1);
  const Image image = make_sheet(sheet);
  const int y = line_with(image, 0, blue, 400);
  REQUIRE(y > 0);
  const int middle = y + 140;  // below the notes
  CHECK(runs(image, middle, blue) == std::vector<std::pair<int, int>>{{40, 500}});
  CHECK(runs(image, middle, red) == std::vector<std::pair<int, int>>{{550, 500}, {1060, 500}});
}

TEST_CASE("a fourth variant beside three, as a reader's own is, stands below them as a column") {
  Sheet sheet = sheet_of(4);
  for (SheetRow& row : sheet.rows) row.cells.resize(1);
  const Image image = make_sheet(sheet);
  CHECK(image.width == 1600);
  const int three = line_with(image, 0, red, 1500);
  REQUIRE(three > 0);
  const int fourth = line_with(image, three + 281, red, 400);
  REQUIRE(fourth > 0);
  CHECK(runs(image, fourth, red) == std::vector<std::pair<int, int>>{{40, 500}});
}

TEST_CASE("cells that were drawn smaller stand on the sheet as large as the others") {
  Sheet sheet = sheet_of(1);
  sheet.rows.front().cells.assign(3, filled(250, 140, red));
  const Image image = make_sheet(sheet);
  const int y = line_with(image, 0, red, 1500);
  REQUIRE(y > 0);
  CHECK(runs(image, y, red).size() == 3);
  CHECK(runs(image, y + 279, red).size() == 3);
}

TEST_CASE("a raster has a column per step, and the colours of its meaning") {
  Sheet sheet = sheet_of(1);
  sheet.raster = Raster{"contact", {}, {{green, "new"}, {red, "kept"}}};
  for (int step = 0; step < 95; ++step)
    sheet.rows.front().raster.push_back({step < 40 ? 0 : 1, -1, step == 94 ? 0 : -1});
  const Image image = make_sheet(sheet);
  const int pictures = line_with(image, 0, red, 1500);
  const int y = line_with(image, pictures + 281, green, 640);
  REQUIRE(y > 0);
  CHECK(runs(image, y, green) == std::vector<std::pair<int, int>>{{40, 640}});  // 1520 / 95 = 16 a step
  CHECK(runs(image, y, red) == std::vector<std::pair<int, int>>{{680, 880}});
  int cell = 0;
  while (is(image, 40, y + cell, green)) ++cell;
  CHECK(cell >= 2);
  CHECK(runs(image, y + cell, green).empty());
  CHECK(runs(image, y + 2 * cell, green) == std::vector<std::pair<int, int>>{{1544, 16}});
}

TEST_CASE("a raster stands beside a row's only picture, and ends where it does") {
  Sheet sheet = sheet_of(1);
  sheet.rows.front().cells.resize(1);
  sheet.raster = Raster{"contact", {}, {{green, "new"}}};
  for (int step = 0; step < 101; ++step) sheet.rows.front().raster.push_back({0, -1, step == 100 ? 0 : -1});
  const Image image = make_sheet(sheet);
  const int picture = line_with(image, 0, red, 500), y = line_with(image, picture, green, 1010);
  REQUIRE(y > picture);
  CHECK(runs(image, y, green) == std::vector<std::pair<int, int>>{{550, 1010}});
  const int last = y + (281 - (y - picture)) * 2 / 3;
  CHECK(runs(image, last, green) == std::vector<std::pair<int, int>>{{1550, 10}});
  CHECK(line_with(image, picture + 281, green, 1) == -1);
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

TEST_CASE("a strobe picture ends when it says, or with its scene") {
  const auto last_instant = [](Real until) {
    const Scratch scratch;
    const std::string out = (scratch / "").string();
    const std::vector<const char*> arguments{"strobe", "--size", "64x36", "--out", out.c_str()};
    Real marked = -1;
    Experiment e("strobe", "When does it end?");
    REQUIRE(e.run(static_cast<int>(arguments.size()), arguments.data(), [&] {
      e.scene({.name = "a ball",
               .fill = [](World& world) { world.add(sphere(1, 1)); },
               .seconds = Real(0.5),
               .marks = [&marked](Picture&, const World&, Real time) { marked = time; },
               .strobe = Strobe{.every = Real(0.1), .shift_per_second = {30, 0, 0}, .until = until}});
      e.motion("still", [](World&, Real, int) -> std::size_t { return 0; });
    }) == 0);
    return marked;
  };
  CHECK(last_instant(Real(0.2)) == Approx(0.2));
  CHECK(last_instant(0) == Approx(0.5));
  CHECK(last_instant(9) == Approx(0.5));
}
