// Pictures that git keeps: when they count as the same, and what is written where they don't.
#include "pushback/common/experiment/kept_picture.h"

#include "pushback/common/basics/input.h"
#include "pushback/common/render/canvas.h"
#include "tests/support/call.h"

using namespace pushback;

namespace {

/// A grey floor under a sky, a ball with its shade, a word: what sheets are made of.
Image small_sheet(const std::string& word) {
  Image image(200, 120);
  for (int y = 0; y < 120; ++y) fill_rectangle(image, 0, y, 200, 1, {static_cast<std::uint8_t>(150 + y / 2), 190, 200});
  for (int r = 30; r > 0; --r)
    fill_disc(image, 60, 60, static_cast<float>(r), {static_cast<std::uint8_t>(240 - 5 * r), 90, 30});
  write_text(image, word, 100, 60, 18);
  return image;
}

/// Each `every`-th level is up to `most` off.
Image scattered(Image image, int most, std::size_t every) {
  std::uint32_t random = 1;
  for (std::size_t i = 0; i < image.pixels.size(); i += every) {
    random = random * 1664525 + 1013904223;
    const int off = static_cast<int>(random >> 16) % (2 * most + 1) - most;
    image.pixels[i] = static_cast<std::uint8_t>(std::clamp(image.pixels[i] + off, 0, 255));
  }
  return image;
}

/// As another OpenGL may round.
Image rounded_otherwise(const Image& image) {
  return scattered(image, 1, 5);
}

}  // namespace

TEST_CASE("what rounds otherwise shows the same, and a digit, a dot, a size that has changed does not") {
  const Image sheet = small_sheet("29.8 %");
  CHECK(shows_the_same(sheet, sheet));
  CHECK(shows_the_same(sheet, rounded_otherwise(sheet)));
  CHECK_FALSE(shows_the_same(sheet, scattered(sheet, 12, 1)));
  for (const char* other : {"29.3 %", "28.8 %", "29,8 %", "-29.8 %", "29.8 °"}) {
    INFO(other);
    CHECK_FALSE(shows_the_same(sheet, small_sheet(other)));
  }
  Image dotted = sheet;
  fill_disc(dotted, 150, 100, 2, {0, 168, 245});
  CHECK_FALSE(shows_the_same(sheet, dotted));
  CHECK_FALSE(shows_the_same(sheet, Image(200, 119)));
  Image speckled = sheet;  // one pixel in fifty differs clearly, none of them beside another
  for (std::size_t i = 0; i < speckled.pixels.size(); i += std::size_t{4} * 50) speckled.pixels[i] += 40;
  CHECK_FALSE(shows_the_same(sheet, speckled));
}

TEST_CASE("a picture that shows the same already is left as it is") {
  const Scratch folder;
  const fs::path file = folder / "sheet.png";
  const Image sheet = small_sheet("stands");
  keep_picture(file, sheet);
  const std::string bytes = text_of(file);
  const auto before = fs::last_write_time(file) - std::chrono::hours(1);
  fs::last_write_time(file, before);
  keep_picture(file, rounded_otherwise(sheet));
  CHECK(fs::last_write_time(file) == before);
  CHECK((text_of(file) == bytes));

  keep_picture(file, small_sheet("fell"));
  CHECK(shows_the_same(read_png(file), small_sheet("fell")));
  keep_picture(file, sheet);
  CHECK((text_of(file) == bytes));  // the same picture is the same bytes
  std::ofstream(file) << "words";
  keep_picture(file, sheet);
  CHECK((text_of(file) == bytes));
  CHECK(std::distance(fs::directory_iterator(folder / ""), fs::directory_iterator()) == 1);
}
