/// The programs that README.md and docs/your_own_scene.md offer as a beginning: they are those that are compiled here, they run,
/// and their bodies fall, slide and stack.
#include <algorithm>

#include "pushback/chapters/07_warm_start/full_solver.h"
#include "pushback/common/world/situations.h"
#include "tests/support/call.h"

/// The programs, and the root of the sources, as seen from the working directory of the tests.
#ifndef SMALLEST_PROGRAM
#define SMALLEST_PROGRAM "build/release/tests/smallest_program"
#endif
#ifndef STUDENT_PROGRAM
#define STUDENT_PROGRAM "build/release/tests/student_program"
#endif
#ifndef SOURCE_DIR
#define SOURCE_DIR "."
#endif

using namespace pushback;

namespace {

/// Whether the page shows the program's lines between its two marks.
bool shows(const std::string& page, const std::string& source) {
  const std::vector<std::string> program = lines_of(text_of(fs::path(SOURCE_DIR) / source));
  const auto begin = std::ranges::find(program, "// page begins"), end = std::ranges::find(program, "// page ends");
  REQUIRE(begin < end);
  std::vector<std::string> shown{"```cpp"};
  shown.insert(shown.end(), begin + 1, end);
  shown.push_back("```");
  const std::vector<std::string> lines = lines_of(text_of(fs::path(SOURCE_DIR) / page));
  return std::search(lines.begin(), lines.end(), shown.begin(), shown.end()) != lines.end();
}

}  // namespace

TEST_CASE("README.md and docs/your_own_scene.md show the programs that are tested here, line by line") {
  CHECK(shows("README.md", "tests/project/smallest_program.cpp"));
  CHECK(shows("docs/your_own_scene.md", "tests/project/student_program.cpp"));
}

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

TEST_CASE("its bodies do what the page says: the boxes stand, the brick stops, the ball bounces") {
  World world;
  stack(world, 3);
  world.add(box({Real(0.4), Real(0.2), Real(0.4)}, 30).at({-4, Real(0.2), 0}).moving({4, 0, 0}));
  world.add(sphere(Real(0.4), 20).at({2, 3, 0}).bouncy(Real(0.6)));
  FullSolver solver;
  Real bounced_to = 0;
  for (int step = 0; step < 120; ++step) {
    world.step(solver, Real(1) / 60);
    if (step > 60) bounced_to = std::max(bounced_to, world.bodies[5].position.y());
  }
  const Body& top = world.bodies[3];
  CHECK(top.position.y() > Real(2.45));
  CHECK(top.velocity.norm() < Real(0.1));
  const Body& brick = world.bodies[4];
  CHECK(brick.velocity.norm() < Real(1e-3));
  CHECK(brick.position.x() == Approx(-4 + 16 / (2 * 0.5 * 9.81)).epsilon(0.03));  // v^2 / 2 mu g
  CHECK(bounced_to == Approx(0.4 + 0.36 * 2.6).epsilon(0.05));                    // e^2 h
}
