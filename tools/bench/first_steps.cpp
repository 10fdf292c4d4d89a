/// How the first steps of many bodies grow, for cubes of touching balls without stored impulses. Counters are seconds of the
/// steps, and of the first one µs in N log2 N.
#include <benchmark/benchmark.h>

#include <cmath>

#include "pushback/engine/presets.h"
#include "pushback/tools/bench/in_turn.h"

using namespace pushback;

namespace {

/// side^3 balls of 1 m, each on the next.
World cube(int side) {
  World world;
  world.add(ground());
  for (int y = 0; y < side; ++y)
    for (int z = 0; z < side; ++z)
      for (int x = 0; x < side; ++x) world.add(sphere(Real(0.5), 1).at({Real(x), Real(y) + Real(0.5), Real(z)}));
  return world;
}

template <class Solver>
void first_steps(benchmark::State& state) {
  const int side = static_cast<int>(state.range(0));
  const double count = std::pow(side, 3);
  for (auto _ : state) {
    World world = cube(side);
    Solver solver;
    for (const char* step : {"1st step, s", "2nd step, s", "3rd step, s"})
      state.counters[step] = seconds_of([&] { world.step(solver, Real(1) / 60); });
  }
  state.counters["balls"] = count;
  state.counters["1st, us / (N log N)"] = 1e6 * state.counters["1st step, s"] / (count * std::log2(count));
}
BENCHMARK(first_steps<Recommended>)->Arg(10)->Arg(16)->Arg(25)->Arg(46)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK(first_steps<Fast>)->Arg(10)->Arg(16)->Arg(25)->Arg(46)->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace
