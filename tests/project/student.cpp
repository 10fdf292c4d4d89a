/// The program that the README offers as a beginning: it is the one that is compiled here, it runs, and its bodies
/// fall, slide and stack.
#include <algorithm>

#include "pushback/chapters/07_warm_start/full_solver.h"
#include "pushback/common/world/situations.h"
#include "tests/support/call.h"

/// The program, and the root of the sources, both as seen from the working directory of the tests.
#ifndef STUDENT_PROGRAM
#define STUDENT_PROGRAM "build/release/tests/student_program"
#endif
#ifndef SOURCE_DIR
#define SOURCE_DIR "."
#endif

using namespace pushback;

TEST_CASE("README.md shows the program that is tested here, line by line") {
  const std::vector<std::string> program =
      lines_of(text_of(fs::path(SOURCE_DIR) / "tests/project/student_program.cpp"));
  const auto begin = std::find(program.begin(), program.end(), "// README begins");
  const auto end = std::find(program.begin(), program.end(), "// README ends");
  REQUIRE(begin < end);
  std::vector<std::string> shown{"```cpp"};
  shown.insert(shown.end(), begin + 1, end);
  shown.push_back("```");
  const std::vector<std::string> readme = lines_of(text_of(fs::path(SOURCE_DIR) / "README.md"));
  CHECK(std::search(readme.begin(), readme.end(), shown.begin(), shown.end()) != readme.end());
}

TEST_CASE("the README's program runs and leaves its numbers behind") {
  const Scratch scratch;
  CHECK(call_program(STUDENT_PROGRAM, "--no-images --out '" + (scratch / "").string() + "'").status == 0);
  // Three variants of 2 s, 120 steps each, and the header.
  CHECK(lines_of(text_of(scratch / "my_experiment/metrics.csv")).size() == 1 + 3 * 120);
}

TEST_CASE("its bodies do what the README says: the boxes stand, the brick stops, the ball bounces") {
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
