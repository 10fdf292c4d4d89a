/// How far bodies sink on contacts that are as stiff as the substeps allow: as 1 / w^2, beyond 32 substeps as well.
#include "pushback/common/world/measure.h"
#include "pushback/common/world/situations.h"
#include "pushback/engine/substeps/wide_solver.h"
#include "tests/support/catch.h"
#include "tests/support/yardstick.h"

using namespace pushback;

namespace {

struct Sunk {
  Real farthest = 0;  ///< m, of all bodies, down
  Real overlap = 0;   ///< m, the deepest
  Real yield;         ///< g / w^2, m
};

/// The recommended solver, without its limit of 240 Hz, for 5 s.
Sunk sunk(const std::function<void(World&)>& fill, int substeps) {
  World world;
  fill(world);
  std::vector<Vec3> start;
  for (const Body& body : world.bodies) start.push_back(body.position);
  WideSolver<Real> solver;
  solver.substeps = substeps;
  solver.spring.hertz = Real(1e6);
  for (int step = 0; step < 300; ++step) world.step(solver, h);
  const Real w = solver.spring.angular_frequency(h / static_cast<Real>(substeps));
  Sunk sunk{.overlap = deepest_overlap(world), .yield = g / (w * w)};
  for (std::size_t i = 0; i < start.size(); ++i)
    sunk.farthest = std::max(sunk.farthest, start[i].y() - world.bodies[i].position.y());
  return sunk;
}

}  // namespace

TEST_CASE("the top of a stack of n sinks by n^2 g / w^2, beyond 32 substeps as well") {
  for (const auto& [boxes, substeps] : {std::pair{10, 32}, {10, 67}, {40, 32}, {40, 67}}) {
    const auto [farthest, overlap, yield] = sunk([n = boxes](World& world) { stack(world, n); }, substeps);
    const Real n = static_cast<Real>(boxes);
    INFO(boxes << " boxes, " << substeps << " substeps: " << 1000 * farthest << " mm, should be "
               << 1000 * n * n * yield << " mm; overlap " << 1000 * overlap << " mm");
    CHECK(farthest == Approx(n * n * yield).epsilon(in_double ? 1e-5 : 0.05));
    CHECK(overlap == Approx(2 * (n - 1) * yield).epsilon(in_double ? 5e-3 : 0.2));
  }
}

TEST_CASE(
    "the fewest substeps below 0.1 mm, where stiffness may grow: 67 for a stack of ten, 38 for a pyramid of base ten") {
  if (!in_double) return;  // 0.1 mm is 50 times the rounding of a height of 10 m
  for (const auto& [fill, fewest] : {std::pair<std::function<void(World&)>, int>{[](World& w) { stack(w, 10); }, 67},
                                     {[](World& w) { pyramid(w, 10); }, 38}}) {
    CHECK(sunk(fill, fewest).farthest < Real(1e-4));
    CHECK(sunk(fill, fewest - 1).farthest > Real(1e-4));
  }
}
