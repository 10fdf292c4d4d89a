/// Each chapter's sheet against a small image of it that was looked at and stored. A picture may differ a little from one
/// OpenGL to the next: the comparison is of averages over blocks of pixels, with a tolerance.
///
/// CHAPTER=NN_name in the environment compares the sheet of that chapter; without it, all are compared. PUSHBACK_STORE_IMAGES=1
/// stores what the chapters draw now. Look at every one of them before you commit it.
#include <cstdlib>

#include "pushback/common/render/canvas.h"
#include "tests/support/call.h"

using namespace pushback;

namespace {

/// The sheet of a chapter, drawn small: the cells at half their size, the whole then 600 pixels wide.
Image small_sheet(const std::string& chapter) {
  const Scratch out;
  REQUIRE(call_program(fs::path(CHAPTER_DIR) / chapter, "--size 176x99 --frames 0 --out " + (out / "").string(), 0)
              .status == 0);
  const Image sheet = read_png(out / chapter / "sheet.png");
  return resized(sheet, 600, sheet.height * 600 / sheet.width);
}

void compare(const std::string& chapter) {
  const fs::path stored_at = fs::path("tests/images") / (chapter + ".png");
  const Image drawn = small_sheet(chapter);
  if (std::getenv("PUSHBACK_STORE_IMAGES") != nullptr) {
    fs::create_directories(stored_at.parent_path());
    write_png(stored_at, drawn);
  }
  const Image stored = read_png(stored_at);
  REQUIRE(drawn.width == stored.width);
  REQUIRE(drawn.height == stored.height);
  const Difference d = difference(drawn, stored);
  INFO(chapter << ": mean difference " << d.mean << " of 255, " << 100 * d.share << " % of the pixels differ clearly");
  CHECK(d.mean < 0.5);
  CHECK(d.share < 0.005);
}

}  // namespace

TEST_CASE("a chapter's sheet looks as it did") {
  if (const char* chapter = std::getenv("CHAPTER")) return compare(chapter);
  for (const auto& entry : fs::directory_iterator("chapters"))
    if (entry.is_directory()) compare(entry.path().filename().string());
}
