/// Chapter 23's crew beside what libraries have ready: the same parts, given to OpenMP's and oneTBB's threads, each beside one thread.
#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <omp.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include "pushback/chapters/22_wide/wide.h"
#include "pushback/chapters/23_threads/crew.h"
#include "pushback/common/world/situations.h"
#include "pushback/tools/bench/in_turn.h"

using namespace pushback;

namespace {

using Those = std::function<std::shared_ptr<Workers>()>;

constexpr Real dt = Real(1) / 60;
constexpr int threads = 2;
constexpr std::size_t cuts = 4 * threads;  // as many as a crew cuts

class OfOpenMP : public Workers {
 public:
  OfOpenMP() : Workers(cuts) {}

 private:
  void share(std::size_t count, const std::function<void(std::size_t)>& act) override {
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads)
    for (std::size_t k = 0; k < count; ++k) act(k);
  }
};

class OfTBB : public Workers {
 public:
  OfTBB() : Workers(cuts) {}

 private:
  void share(std::size_t count, const std::function<void(std::size_t)>& act) override {
    arena_.execute(
        [&] { tbb::parallel_for(std::size_t{0}, count, [&](std::size_t k) { act(k); }, tbb::simple_partitioner{}); });
  }
  tbb::task_arena arena_{threads};
};

/// Medians over the steps of a pile, in 8 substeps, beside one thread. One of the three at a time: their threads go on turning around
/// for a while when there is nothing to do, on the core that those of another need.
void pile_of(benchmark::State& state, const Those& those, int n, int high) {
  struct {
    World world;
    Wide<float> solver;
  } one, many;
  heap(one.world, n, high, -static_cast<Real>(n) / 2);
  one.solver.substeps = many.solver.substeps = 8;
  for (int i = 0; i < 240; ++i) one.world.step(one.solver, dt);
  many.world = one.world;
  many.solver.crew = those();
  const auto step_of = [](auto& lane) { return [&] { return seconds_of([&] { lane.world.step(lane.solver, dt); }); }; };
  InTurn turns;
  for (auto _ : state) turns.round({step_of(one), step_of(many)});
  state.counters["bodies"] = static_cast<double>(one.world.bodies.size());
  state.counters["1 thread, us"] = 1e6 * turns.time(0);
  state.counters["times as fast"] = 1 / turns.ratio(1, 0);
}

void piles(const std::string& name, const Those& those) {
  struct Pile {
    int n, high, steps;
  };
  for (const Pile& pile : {Pile{8, 8, 200}, {10, 10, 120}, {20, 10, 60}})
    benchmark::RegisterBenchmark(fmt::format("{}/pile of {}", name, pile.n * pile.n * pile.high).c_str(),
                                 [=](benchmark::State& state) { pile_of(state, those, pile.n, pile.high); })
        ->Iterations(pile.steps)
        ->Unit(benchmark::kMicrosecond);
}

/// A round in which nobody has anything to do.
void empty_round(const std::string& name, const Those& those) {
  benchmark::RegisterBenchmark((name + "/nothing").c_str(), [=](benchmark::State& state) {
    const std::shared_ptr<Workers> all = those();
    for (auto _ : state) all->each(cuts, 1, [](Part) {});
  });
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::pair<std::string, Those>> all{{"crew", [] { return std::make_shared<Crew>(threads); }},
                                                       {"OpenMP", [] { return std::make_shared<OfOpenMP>(); }},
                                                       {"oneTBB", [] { return std::make_shared<OfTBB>(); }}};
  for (const auto& [name, those] : all) piles(name, those);
  for (const auto& [name, those] : all) empty_round(name, those);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
}
