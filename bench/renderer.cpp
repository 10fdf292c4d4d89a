/// Frames per second of the renderer, with everything on.
#include <benchmark/benchmark.h>

#include "pushback/chapters/07_warm_start/full_solver.h"
#include "pushback/common/experiment/picture_of.h"
#include "pushback/common/render/painter.h"
#include "pushback/common/world/situations.h"

using namespace pushback;

namespace {

/// A pyramid of 210 boxes with its contact points and impulses.
Picture busy_picture() {
  World world;
  pyramid(world, 20);
  FullSolver solver;
  for (int step = 0; step < 30; ++step) world.step(solver, Real(1) / 60, 10);
  return picture_of(world, {{8, 10, 26}, {0, 8, 0}}, fitting_arrow(world, Real(1) / 60));
}

void frame(benchmark::State& state) {
  const Picture picture = busy_picture();
  Painter painter(640, 360);
  for (auto _ : state) benchmark::DoNotOptimize(painter.draw(picture).pixels.data());
  state.counters["frames per second"] = benchmark::Counter(1, benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(frame)->Unit(benchmark::kMillisecond)->UseRealTime();

void still_of_sixteen_passes(benchmark::State& state) {
  const Picture picture = busy_picture();
  Painter painter(640, 360);
  for (auto _ : state) benchmark::DoNotOptimize(painter.draw_still(picture, 16).pixels.data());
}
BENCHMARK(still_of_sixteen_passes)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(3);

/// Of a cell of a sheet: the passes, and what of them are arrows and dots.
void cell_of_a_sheet(benchmark::State& state) {
  Picture picture = busy_picture();
  if (state.range(1) == 0) picture.arrows = {}, picture.dots = {};
  Painter painter(500, 281);
  for (auto _ : state)
    benchmark::DoNotOptimize(painter.draw_still(picture, static_cast<int>(state.range(0))).pixels.data());
}
BENCHMARK(cell_of_a_sheet)
    ->ArgNames({"passes", "marks"})
    ->Args({16, 1})
    ->Args({16, 0})
    ->Args({1, 1})
    ->Unit(benchmark::kMillisecond);

}  // namespace
