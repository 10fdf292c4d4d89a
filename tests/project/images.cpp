/// Each chapter's sheet against a small image of it that was looked at and stored. A picture may differ a little from one
/// OpenGL to the next: the comparison is of averages over blocks of pixels, with a tolerance.
///
/// PUSHBACK_STORE_IMAGES=1 stores what the chapters draw now. Look at every one of them before you commit it.
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

TEST_CASE("the sheet of 00 looks as it did") {
  compare("00_naive_impulses");
}
TEST_CASE("the sheet of 01 looks as it did") {
  compare("01_velocity_constraint");
}
TEST_CASE("the sheet of 02 looks as it did") {
  compare("02_clamping");
}
TEST_CASE("the sheet of 03 looks as it did") {
  compare("03_baumgarte");
}
TEST_CASE("the sheet of 04 looks as it did") {
  compare("04_slop");
}
TEST_CASE("the sheet of 05 looks as it did") {
  compare("05_restitution");
}
TEST_CASE("the sheet of 06 looks as it did") {
  compare("06_friction");
}
TEST_CASE("the sheet of 07 looks as it did", "[checked]") {
  compare("07_warm_start");
}
TEST_CASE("the sheet of 08 looks as it did") {
  compare("08_friction_cone");
}
TEST_CASE("the sheet of 09 looks as it did") {
  compare("09_impacts");
}
TEST_CASE("the sheet of 10 looks as it did", "[slow]") {
  compare("10_position_correction");
}
TEST_CASE("the sheet of 11 looks as it did", "[checked]") {
  compare("11_substeps");
}
TEST_CASE("the sheet of 12 looks as it did", "[checked]") {
  compare("12_soft_contacts");
}
TEST_CASE("the sheet of 13 looks as it did") {
  compare("13_joints");
}
TEST_CASE("the sheet of 14 looks as it did", "[checked]") {
  compare("14_joints_under_load");
}
TEST_CASE("the sheet of 15 looks as it did") {
  compare("15_limits_motors_springs");
}
TEST_CASE("the sheet of 16 looks as it did", "[slow]") {
  compare("16_whole_problem");
}
TEST_CASE("the sheet of 17 looks as it did", "[slow]") {
  compare("17_direct_contacts");
}
TEST_CASE("the sheet of 18 looks as it did") {
  compare("18_direct_joints");
}
TEST_CASE("the sheet of 19 looks as it did") {
  compare("19_accuracy_and_time");
}
TEST_CASE("the sheet of 20 looks as it did") {
  compare("20_only_what_is_needed");
}
TEST_CASE("the sheet of 21 looks as it did", "[slow]") {
  compare("21_detected_once");
}
TEST_CASE("the sheet of 22 looks as it did") {
  compare("22_wide");
}
TEST_CASE("the sheet of 23 looks as it did") {
  compare("23_threads");
}
TEST_CASE("the sheet of 24 looks as it did") {
  compare("24_half_step");
}
TEST_CASE("the sheet of 25 looks as it did") {
  compare("25_moment_of_impact");
}
TEST_CASE("the sheet of 26 looks as it did") {
  compare("26_to_each_its_own");
}
TEST_CASE("the sheet of 27 looks as it did") {
  compare("27_which_error");
}
