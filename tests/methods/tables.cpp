/// What docs/methods.md shows is made of measurements. Those here are made up.
#include "pushback/tools/study/every_motion.h"
#include "pushback/tools/study/methods.h"
#include "tests/support/catch.h"

using namespace pushback;
using namespace pushback::study;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

Measured of(const std::string& method, int substeps, int sweeps, double error, double seconds) {
  return {.engine = "motion_methods",
          .method = method,
          .substeps = substeps,
          .sweeps = sweeps,
          .error = error,
          .seconds = {seconds}};
}

std::vector<MotionMeasured> measured() {
  Measured given_up = of("block", 16, 1, infinite, 5);
  given_up.late = true;
  return {{&any_motion_named("rolling"),
           {of("slim", 16, 1, 0.0123, 0.012), of("slim", 32, 1, 0.00049, 0.024), of("half-step", 16, 0, 1e-9, 0.001),
            of("xpbd", 16, 1, infinite, 0.1), of("shock", 16, 1, 0.0005, 0.001), of("shock", 32, 1, 0.5, 0.002),
            of("full", 16, 1, 1, 1)}},
          {&any_motion_named("bounce"), {given_up}}};
}

}  // namespace

TEST_CASE(
    "methods: the table of errors has a row a method, ours first, and says what was lost, given up, or not played") {
  CHECK(table_of_errors(measured(), 16, 1) ==
        "| method | `rolling` | `bounce` |\n"
        "| --- | --- | --- |\n"
        "| `slim` | 12 | – |\n"
        "| `half-step` | 0.00010 | – |\n"
        "| `xpbd` | lost | – |\n"
        "| `block` | – | late |\n"
        "| `shock` | 0.50 | – |\n");
}

// A setting counts with the largest error of all that are finer: shock's 16/1 is no 1 mm.
TEST_CASE("methods: the table of times has the fastest setting whose robust error is small enough") {
  CHECK(table_of_times(measured(), 1e-3) ==
        "| method | `rolling` | `bounce` |\n"
        "| --- | --- | --- |\n"
        "| `slim` | 200 µs, `32/1` | – |\n"
        "| `half-step` | 8.3 µs, `16` | – |\n"
        "| `xpbd` | not reached | – |\n"
        "| `block` | – | not reached |\n"
        "| `shock` | not reached | – |\n");
}

TEST_CASE("methods: a diagram has a line for each method that was compared, and for no other") {
  const Panel panel = fronts_of_compared(measured()[0]);
  std::vector<std::string> labels;
  for (const Curve& curve : panel.curves) labels.push_back(curve.label);
  CHECK(labels == std::vector<std::string>{"slim", "half-step", "shock"});
}
