/// The programs that README.md and docs/your_own_scene.md offer as a beginning run.
#include "tests/support/call.h"

TEST_CASE("the smallest program prints what README.md says") {
  const Ended call = call_program(SMALLEST_PROGRAM, "");
  CHECK(call.status == 0);
  CHECK(call.out == "The top box is at 9.5000 m.\n");
  CHECK(contains(text_of(fs::path(SOURCE_DIR) / "README.md"), "`" + lines_of(call.out)[0] + "`"));
}

TEST_CASE("the program with pictures runs and leaves its numbers behind") {
  const Scratch scratch;
  CHECK(call_program(STUDENT_PROGRAM, "--no-images --out '" + (scratch / "").string() + "'").status == 0);
  // Three variants of 2 s, 120 steps each, and the header.
  CHECK(lines_of(text_of(scratch / "my_experiment/metrics.csv")).size() == 1 + 3 * 120);
}
