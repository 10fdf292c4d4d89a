/// What a further substep costs chapter 22's solver, a contact, and why it costs more in a pile than in columns.
///
/// All that is compared steps the same world, in turn within one run; counters are medians.
#include <benchmark/benchmark.h>

#include <numeric>

#include "pushback/chapters/22_wide/study.h"
#include "pushback/common/bodies/random.h"
#include "pushback/common/world/situations.h"
#include "pushback/tools/bench/in_turn.h"

using namespace pushback;

namespace {

constexpr Real dt = Real(1) / 60;
constexpr int few = 4, many = 12;

/// In ns a contact: of a substep; of one whose rows are never placed anew; of what a step costs besides. And the lanes' part that has
/// a contact.
void substep(benchmark::State& state, const std::function<void(World&)>& fill, int settle) {
  World world;
  fill(world);
  Wide<float> settling;
  settling.substeps = 8;
  for (int i = 0; i < settle; ++i) world.step(settling, dt);
  struct Way {
    int substeps;
    bool placed_anew;
    World world;
    Wide<float> solver;
  };
  std::vector<Way> ways;
  for (const bool anew : {true, false})
    for (const int substeps : {few, many}) ways.push_back({substeps, anew, {}, {}});
  std::vector<std::function<double()>> steps;
  for (Way& way : ways) {
    way.solver.substeps = way.substeps;
    if (!way.placed_anew) way.solver.stays_within = 1;
    steps.emplace_back([&] {
      way.world = world;  // and in the caches, as if it had been there all the time
      return seconds_of([&] { way.world.step(way.solver, dt); });
    });
  }
  InTurn turns;
  double contacts = 0;
  for (auto _ : state) {
    turns.round(steps);
    contacts = static_cast<double>(ways[0].world.contacts.size());
    world.step(settling, dt);
  }
  const double to_ns = 1e9 / contacts;
  const double anew = turns.difference(1, 0) / (many - few), kept = turns.difference(3, 2) / (many - few);
  state.counters["contacts"] = contacts;
  state.counters["1 a substep"] = to_ns * anew;
  state.counters["2 rows kept"] = to_ns * kept;
  state.counters["3 besides"] = to_ns * (turns.time(0) - few * anew);
  state.counters["4 lanes used"] = static_cast<double>(wide_scenes::part_filled(wide_scenes::sets_in(ways[0].world)));
}

/// 400 boxes in columns of ten; in the order in which they stand, or as chance has it in memory.
void columns(World& world, bool in_order) {
  world.add(ground());
  std::vector<std::size_t> order(400);
  std::iota(order.begin(), order.end(), 0);
  if (!in_order) Random(1).shuffle(order);
  for (const std::size_t i : order)
    world.add(box(Vec3::Constant(Real(0.5)), 100)
                  .at({2 * static_cast<Real>(i / 10), Real(0.5) + static_cast<Real>(i % 10), 0}));
}

void of_columns(benchmark::State& state) {
  substep(state, [](World& world) { columns(world, true); }, 120);
}
void of_columns_out_of_order(benchmark::State& state) {
  substep(state, [](World& world) { columns(world, false); }, 120);
}
void of_pyramid_of_210(benchmark::State& state) {
  substep(state, [](World& world) { pyramid(world, 20); }, 120);
}
void of_pile_of_512(benchmark::State& state) {
  substep(state, [](World& world) { heap(world, 8, 8, -4); }, 240);
}
void of_pile_of_4000(benchmark::State& state) {
  substep(state, [](World& world) { heap(world, 20, 10, -10); }, 240);
}
BENCHMARK(of_columns)->Iterations(100)->Unit(benchmark::kMicrosecond);
BENCHMARK(of_columns_out_of_order)->Iterations(100)->Unit(benchmark::kMicrosecond);
BENCHMARK(of_pyramid_of_210)->Iterations(100)->Unit(benchmark::kMicrosecond);
BENCHMARK(of_pile_of_512)->Iterations(60)->Unit(benchmark::kMicrosecond);
BENCHMARK(of_pile_of_4000)->Iterations(20)->Unit(benchmark::kMicrosecond);

}  // namespace
