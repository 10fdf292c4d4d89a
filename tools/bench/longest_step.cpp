/// The longest step beside the median one, where bodies meet. Each step is the least of five runs, so that other load does not count.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <limits>

#include "pushback/common/bodies/random.h"
#include "pushback/engine/presets.h"
#include "pushback/tools/bench/in_turn.h"
#include "pushback/tools/measure/study/further_motions.h"

using namespace pushback;

namespace {

constexpr int runs = 5, steps = 240;

World on_ground(const std::vector<Body>& bodies) {
  World world;
  world.add(ground());
  for (const Body& body : bodies) world.add(body);
  return world;
}

Body cube(Real half, Real mass) {
  return box({half, half, half}, mass);
}
World heavy_on_light() {
  return on_ground({cube(Real(0.5), 1).at({0, Real(0.5), 0}), cube(Real(0.5), 100).at({0, Real(2.5), 0})});
}
World thrown_bar() {
  return on_ground({box({1, Real(0.1), Real(0.1)}, 1).at({0, 2, 0}).moving({1, 0, 0}).spinning({1, 2, 5})});
}
World ten_dropped(Real aside) {
  Random random(1);
  std::vector<Body> bodies;
  for (int i = 0; i < 10; ++i) {
    const Real x = random.between(-aside, aside), z = random.between(-aside, aside);
    bodies.push_back(cube(Real(0.25), 1).at({x, 1 + Real(0.6) * static_cast<Real>(i), z}));
  }
  return on_ground(bodies);
}
World ten_in_a_heap() {
  return ten_dropped(Real(0.5));
}
World ten_in_a_column() {
  return ten_dropped(Real(0.05));
}
World pyramid_of_hulls() {
  World world;
  further::PileOfHulls{}(world);
  return world;
}

template <class Solver, World (*scene)()>
void longest(benchmark::State& state) {
  for (auto _ : state) {
    std::vector<double> least(steps, std::numeric_limits<double>::infinity());
    for (int run = 0; run < runs; ++run) {
      World world = scene();
      Solver solver;
      for (double& time : least) time = std::min(time, seconds_of([&] { world.step(solver, Real(1) / 60); }));
    }
    const double middle = median(least), most = *std::max_element(least.begin(), least.end());
    state.counters["median, us"] = 1e6 * middle;
    state.counters["longest, us"] = 1e6 * most;
    state.counters["ratio"] = most / middle;
  }
}
BENCHMARK_TEMPLATE(longest, Recommended, heavy_on_light)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(longest, Recommended, thrown_bar)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(longest, Recommended, ten_in_a_heap)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(longest, Recommended, ten_in_a_column)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(longest, Recommended, pyramid_of_hulls)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(longest, Fast, heavy_on_light)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(longest, Fast, thrown_bar)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(longest, Fast, ten_in_a_heap)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(longest, Fast, ten_in_a_column)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(longest, Fast, pyramid_of_hulls)->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace
