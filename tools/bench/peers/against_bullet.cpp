/// Chapters 12, 21 and 22 beside Bullet's default (float, 10 sweeps), on the same scenes: steps of 1/60 s, timed in turn within one run.
#include <benchmark/benchmark.h>

#include "pushback/chapters/21_detected_once/study.h"
#include "pushback/chapters/22_wide/wide.h"
#include "pushback/common/bodies/random.h"
#include "pushback/common/world/any_solver.h"
#include "pushback/common/world/measure.h"
#include "pushback/common/world/situations.h"
#include "pushback/tools/bench/in_turn.h"
#include "pushback/tools/peers/peer.h"

using namespace pushback;

namespace {

constexpr Real dt = Real(1) / 60;

struct Way {
  const char* name;
  AnySolver solver;
  int steps;  // of 1/60 s: into how many it is cut from outside
};

template <class Solver>
Solver in(int substeps) {
  Solver solver;
  solver.substeps = substeps;
  return solver;
}

/// Medians of the ratios to Bullet's time for the same step, and how deep contacts are at the end, mm.
void beside_bullet(benchmark::State& state, const std::function<void(World&)>& fill, int substeps, int settle) {
  const std::vector<Way> ways{{"chapter 12", detected_once_scenes::DetectedInEach{}, substeps},
                              {"once", in<DetectedOnce>(substeps), 1},
                              {"wide, double", in<Wide<double>>(substeps), 1},
                              {"wide, float", in<Wide<float>>(substeps), 1}};
  Motion motion{.name = "", .title = "", .fill = fill, .seconds = 1, .truth = {}};
  const std::unique_ptr<Player> bullet = peer_methods().front().begin(motion, {.substeps = 1, .sweeps = 10});
  std::vector<World> worlds(ways.size());
  std::vector<AnySolver> solvers;
  std::vector<std::function<double()>> things{[&] { return seconds_of([&] { bullet->frame(1); }); }};
  for (std::size_t i = 0; i < ways.size(); ++i) {
    fill(worlds[i]);
    solvers.push_back(ways[i].solver);
  }
  for (std::size_t i = 0; i < ways.size(); ++i) {
    things.emplace_back([&, i] {
      return seconds_of([&] {
        for (int k = 0; k < ways[i].steps; ++k) worlds[i].step(solvers[i], dt / static_cast<Real>(ways[i].steps), 1);
      });
    });
  }
  for (int i = 0; i < settle; ++i)
    for (const auto& thing : things) thing();
  InTurn turns;
  for (auto _ : state) turns.round(things);
  state.counters["Bullet, us"] = 1e6 * turns.time(0);
  for (std::size_t i = 0; i < ways.size(); ++i) {
    state.counters[std::string(ways[i].name) + " / Bullet"] = turns.ratio(i + 1, 0);
    worlds[i].find_contacts();
    state.counters[std::string(ways[i].name) + ", mm"] = 1000 * deepest_overlap(worlds[i]);
    state.counters["contacts"] = static_cast<double>(worlds[i].contacts.size());
  }
}

void pyramid_of_210(benchmark::State& state) {
  beside_bullet(state, [](World& world) { pyramid(world, 20); }, 8, 300);
}
void pyramid_of_210_in_4_substeps(benchmark::State& state) {
  beside_bullet(state, [](World& world) { pyramid(world, 20); }, 4, 300);
}
void pyramid_of_210_as_recommended(benchmark::State& state) {
  beside_bullet(state, [](World& world) { pyramid(world, 20); }, Wide<Real>{}.substeps, 120);
}
void stack_of_40(benchmark::State& state) {
  beside_bullet(state, [](World& world) { stack(world, 40); }, 32, 120);
}
void pile_of_512(benchmark::State& state) {
  beside_bullet(state, [](World& world) { heap(world, 8, 8, -4); }, 8, 240);
}
void pile_of_4000(benchmark::State& state) {
  beside_bullet(state, [](World& world) { heap(world, 20, 10, -10); }, 8, 240);
}
BENCHMARK(pyramid_of_210)->Iterations(200)->Unit(benchmark::kMicrosecond);
BENCHMARK(pyramid_of_210_in_4_substeps)->Iterations(200)->Unit(benchmark::kMicrosecond);
BENCHMARK(pyramid_of_210_as_recommended)->Iterations(60)->Unit(benchmark::kMicrosecond);
BENCHMARK(stack_of_40)->Iterations(200)->Unit(benchmark::kMicrosecond);
BENCHMARK(pile_of_512)->Iterations(60)->Unit(benchmark::kMicrosecond);
BENCHMARK(pile_of_4000)->Iterations(20)->Unit(benchmark::kMicrosecond);

}  // namespace
