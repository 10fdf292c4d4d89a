/// Chapter 23: a step with one thread and with two, in turn within one run; and where the second one's time goes.
#include <benchmark/benchmark.h>

#include "pushback/common/world/situations.h"
#include "pushback/engine/substeps/thread_pool.h"
#include "pushback/engine/substeps/wide_solver.h"
#include "pushback/tools/bench/in_turn.h"

using namespace pushback;

namespace {

constexpr Real dt = Real(1) / 60;

/// How long who calls has waited for others, s, and how often.
class TimedPool : public ThreadPool {
 public:
  using ThreadPool::ThreadPool;
  double waited = 0;
  int rounds = 0;

 private:
  void wait_for_others() override {
    waited += seconds_of([&] { ThreadPool::wait_for_others(); });
    ++rounds;
  }
};

/// Parts one after the other on one thread, and the time that would be saved if the parts of a round ran at the same time, s.
class InTurnOnOne : public Workers {
 public:
  explicit InTurnOnOne(int threads)
      : Workers(4 * static_cast<std::size_t>(threads)), until_(static_cast<std::size_t>(threads)) {}
  double saved = 0;

 private:
  void share(std::size_t count, const std::function<void(std::size_t)>& act) override {
    std::fill(until_.begin(), until_.end(), 0);
    for (std::size_t k = 0; k < count; ++k) {
      const double time = seconds_of([&] { act(k); });
      saved += time;
      *std::min_element(until_.begin(), until_.end()) += time;
    }
    saved -= *std::max_element(until_.begin(), until_.end());
  }
  std::vector<double> until_;  // of each thread
};

/// Medians over the steps, of threads as many as asked for against none but the one that calls.
void shared(benchmark::State& state, const std::function<void(World&)>& fill, int threads, int settle) {
  const auto pool = std::make_shared<TimedPool>(threads);
  const auto in_turn = std::make_shared<InTurnOnOne>(threads);
  struct {
    World world;
    WideSolver<float> solver;
  } one, many, ideal;
  fill(one.world);
  one.solver.substeps = many.solver.substeps = ideal.solver.substeps = 8;
  for (int i = 0; i < settle; ++i) one.world.step(one.solver, dt);
  many.world = ideal.world = one.world;
  many.solver.workers = pool;
  ideal.solver.workers = in_turn;
  const auto step_of = [](auto& lane) { return [&] { return seconds_of([&] { lane.world.step(lane.solver, dt); }); }; };
  InTurn turns;
  std::vector<double> waiting, rounds;
  const auto timed = [&] {
    pool->waited = 0;
    pool->rounds = 0;
    const double time = step_of(many)();
    waiting.push_back(pool->waited / time);
    rounds.push_back(pool->rounds);
    return time;
  };
  const auto at_best = [&] {
    in_turn->saved = 0;
    const double time = step_of(ideal)();
    return time - in_turn->saved;
  };
  for (auto _ : state) turns.round({step_of(one), timed, at_best});
  state.counters["bodies"] = static_cast<double>(one.world.bodies.size());
  state.counters["contacts"] = static_cast<double>(one.world.contacts.size());
  state.counters["1 thread, us"] = 1e6 * turns.time(0);
  state.counters[fmt::format("{} threads, us", threads)] = 1e6 * turns.time(1);
  state.counters["times as fast"] = 1 / turns.ratio(1, 0);
  state.counters["at best"] = 1 / turns.ratio(2, 0);
  state.counters["waiting, %"] = 100 * median(waiting);
  state.counters["barriers"] = median(rounds);
}

[[maybe_unused]] const bool added = [] {
  const auto add = [](const std::string& name, const std::function<void(World&)>& fill, int settle, int steps) {
    benchmark::RegisterBenchmark(name.c_str(), shared, fill, 2, settle)
        ->Iterations(steps)
        ->Unit(benchmark::kMicrosecond);
  };
  add("stack_of/10", [](World& world) { stack(world, 10); }, 120, 2000);
  add("stack_of/40", [](World& world) { stack(world, 40); }, 120, 1000);
  add("pyramid_of/55", [](World& world) { pyramid(world, 10); }, 120, 1000);
  add("pyramid_of/210", [](World& world) { pyramid(world, 20); }, 120, 400);
  add("pile_of/125", [](World& world) { heap(world, 5, 5, Real(-2.5)); }, 240, 400);
  add("pile_of/512", [](World& world) { heap(world, 8, 8, -4); }, 240, 100);
  add("pile_of/1000", [](World& world) { heap(world, 10, 10, -5); }, 240, 60);
  add("pile_of/4000", [](World& world) { heap(world, 20, 10, -10); }, 240, 20);
  return true;
}();

/// A round in which no thread has anything to do.
void empty_round(benchmark::State& state) {
  ThreadPool pool(2);
  for (auto _ : state) pool.each(2, 1, [](Part) {});
}
BENCHMARK(empty_round);

}  // namespace
