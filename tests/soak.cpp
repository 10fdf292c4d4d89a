/// A pyramid for 100,000 steps: half an hour of its time. It stands, and asks for no more memory than after its first 1000.
/// With sanitizers it is given SOAK_STEPS, which are fewer.
#include <fmt/format.h>
#include <malloc.h>

#include <cmath>

#include "pushback/common/world/measure.h"
#include "pushback/common/world/situations.h"
#include "pushback/tools/measure/hard_cases/stages.h"
#include "tests/support/catch.h"

using namespace pushback;

namespace {

/// Of the heap, as the C library keeps its books. The sanitizers' own allocator keeps none: there it is always 0.
std::size_t bytes_in_use() {
  const struct mallinfo2 books = mallinfo2();
  return books.uordblks + books.hblkhd;
}

/// m, sideways, of the body that has moved most.
Real drift(const World& world, const std::vector<Body>& start) {
  Real most = 0;
  for (std::size_t i = 0; i < start.size(); ++i) {
    const Vec3 moved = world.bodies[i].position - start[i].position;
    most = std::max(most, std::hypot(moved.x(), moved.z()));
  }
  return most;
}

void soak(const char* stage, int base) {
  World world;
  pyramid(world, base);
  const std::vector<Body> start = world.bodies;
  const Stepper step = stage_named(stage).begin();
  std::size_t early = 0;
  Real drifted = 0;
  for (int i = 1; i <= SOAK_STEPS; ++i) {
    step.step(world, Real(1) / 60);
    if (i == 1000) {
      early = bytes_in_use();
      drifted = drift(world, start);
    }
  }
  const std::size_t late = bytes_in_use();  // before anything is printed: that takes a buffer
  const Real top_fell = start.back().position.y() - world.bodies.back().position.y();
  fmt::print(
      "{}, base {}, {} steps: drift {:.4g} mm after the first 1000, {:.4g} mm at the end; top {:.4g} mm lower; "
      "{:.3g} m/s; {:.4g} mm deep; {} bytes in use after the first 1000, {} at the end\n",
      stage, base, SOAK_STEPS, 1000 * drifted, 1000 * drift(world, start), 1000 * top_fell, largest_speed(world),
      1000 * deepest_overlap(world), early, late);
  CHECK(late == early);
  CHECK(drift(world, start) < Real(0.01));
  CHECK(std::abs(top_fell) < Real(0.01) * base);  // slop, and no more, in each layer
}

}  // namespace

TEST_CASE("a pyramid stands, and its memory does not grow", "[soak][long]") {
  for (const auto& [stage, base] :
       {std::pair{"07 warm start", 10}, {"12 soft contacts", 5}, {"all together", 5}, {"22 wide", 10}})
    soak(stage, base);
}
