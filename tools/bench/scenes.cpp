/// The cost of a step of each scene with all effects and with the needed ones, with one method for all of it and with the step
/// that fits each island; and the cost of sleeping bodies to awake ones.
///
/// All variants are timed in turn within one run, and counters are medians.
#include <benchmark/benchmark.h>

#include "pushback/chapters/14_joints_under_load/jointed_solver.h"
#include "pushback/chapters/20_only_what_is_needed/dispatch.h"
#include "pushback/common/basics/input.h"
#include "pushback/engine/islands/island_solver.h"
#include "pushback/tools/bench/in_turn.h"
#include "pushback/tools/catalogue/catalogue.h"

using namespace pushback;

namespace {

constexpr Real dt = Real(1) / 60;
constexpr int sweeps = 10;

// ---- each scene ----------------------------------------------------------------------------------------------------------

/// 10 s of it, of each step the median.
class Steps {
 public:
  /// Times a step by each of these.
  void round(std::size_t step, const std::vector<std::function<void()>>& ways) {
    std::vector<std::function<double()>> timed;
    for (const auto& way : ways) timed.emplace_back([&way] { return seconds_of(way); });
    turns_[step].round(timed);
  }
  std::size_t count() const { return turns_.size(); }
  /// us
  double mean(std::size_t which) const {
    double sum = 0;
    for (const InTurn& step : turns_) sum += step.time(which);
    return 1e6 * sum / static_cast<double>(count());
  }

 private:
  std::vector<InTurn> turns_ = std::vector<InTurn>(600);
};

/// With everything, with what is called for, and with sleep besides.
void scene(benchmark::State& state, const NamedScene& named) {
  Steps steps;
  for (auto _ : state) {
    for (int run = 0; run < 9; ++run) {
      World all;
      named.fill(all);
      World awake = all, resting = all;
      JointedSolver full;
      OnlyWhatIsNeeded needed(awake, full), with_sleep(resting, full, Sleep{});
      for (std::size_t i = 0; i < steps.count(); ++i)
        steps.round(i, {[&] { all.step(full, dt, sweeps); }, [&] { needed.step(awake, dt, sweeps); },
                        [&] { with_sleep.step(resting, dt, sweeps); }});
    }
  }
  state.counters["1 everything, us"] = steps.mean(0);
  state.counters["2 needed, us"] = steps.mean(1);
  state.counters["3 with sleep, us"] = steps.mean(2);
  state.counters["needed / everything"] = steps.mean(1) / steps.mean(0);
  state.counters["with sleep / everything"] = steps.mean(2) / steps.mean(0);
}

/// With chapter 22's substeps for all, and with each island's own step; and the share of each method in the bodies' steps.
void islands(benchmark::State& state, const NamedScene& named) {
  Steps steps;
  double moved = 0, flying = 0, in_half_steps = 0;
  try {
    for (auto _ : state) {
      for (int run = 0; run < 5; ++run) {
        World at_once;
        named.fill(at_once);
        World divided = at_once;
        WideSolver<Real> one;
        IslandSolver own;
        for (std::size_t i = 0; i < steps.count(); ++i) {
          steps.round(i, {[&] { at_once.step(one, dt); }, [&] { divided.step(own, dt); }});
          for (const Body& body : divided.bodies) {
            if (!body.movable()) continue;
            ++moved;
            flying += own.step_of(body.index) == StepType::flight ? 1 : 0;
            in_half_steps += own.step_of(body.index) == StepType::half_steps ? 1 : 0;
          }
        }
      }
    }
  } catch (const InvalidInput& error) {
    return state.SkipWithError(error.what());
  }
  state.counters["1 one method, us"] = steps.mean(0);
  state.counters["2 each its own, us"] = steps.mean(1);
  state.counters["3 its own / one"] = steps.mean(1) / steps.mean(0);
  state.counters["4 in flight"] = flying / moved;
  state.counters["5 half steps"] = in_half_steps / moved;
}
[[maybe_unused]] const bool registered = [] {
  for (const NamedScene& named : all_scenes()) {
    const auto add = [&](const std::string& what, const auto& function) {
      benchmark::RegisterBenchmark((what + "/" + named.name).c_str(), function, named)
          ->Iterations(1)
          ->Unit(benchmark::kMillisecond);
    };
    add("scene", scene);
    add("islands", islands);
  }
  return true;
}();

// ---- sleepers --------------------------------------------------------------------------------------------------------------

Body cube() {
  return box(Vec3::Constant(Real(0.5)), 100);
}

/// A thousand cubes in piles of this height, 1.2 m from pile to pile, on both sides of an aisle of 1.5 m.
void thousand(World& world, int height) {
  const int in_a_row = height == 1 ? 32 : 16, before_aisle = in_a_row / 2;
  for (int i = 0; i < 1000; ++i) {
    const int pile = i / height, row = pile / in_a_row;
    const Real z = Real(1.2) * Real(row - before_aisle) + (row < before_aisle ? Real(-0.05) : Real(1.25));
    world.add(cube().at({Real(1.2) * Real(pile % in_a_row), Real(0.5) + Real(i % height), z}));
  }
}
/// Five more that slide down the aisle without friction, and never come to rest.
void five(World& world) {
  for (int i = 0; i < 5; ++i) {
    world.add(cube().rough(0).at({Real(2.4) * Real(i), Real(0.5), 0}).moving({3, 0, 0}));
  }
}
std::size_t asleep_in(const World& world) {
  return static_cast<std::size_t>(
      std::count_if(world.bodies.begin(), world.bodies.end(), [](const Body& body) { return body.asleep; }));
}

void thousand_and_five(benchmark::State& state) {
  World with_thousand, alone, all;
  for (World* world : {&with_thousand, &alone, &all}) world->add(ground());
  for (World* world : {&with_thousand, &all}) thousand(*world, static_cast<int>(state.range(0)));
  OnlyWhatIsNeeded with_sleepers(with_thousand, FullSolver{}, Sleep{});
  for (int step = 0; step < 600 && asleep_in(with_thousand) < 1000; ++step) with_sleepers.step(with_thousand, dt);
  const double islands = static_cast<double>(with_sleepers.sleep->asleep().size());
  for (World* world : {&with_thousand, &alone, &all}) five(*world);
  World alone_without_sleep = alone;
  OnlyWhatIsNeeded five_alone(alone, FullSolver{}, Sleep{}), without_sleep(alone, FullSolver{});

  InTurn turns;
  std::size_t asleep = 1000;
  for (auto _ : state) {
    turns.round({[&] { return seconds_of([&] { with_sleepers.step(with_thousand, dt, sweeps); }); },
                 [&] { return seconds_of([&] { five_alone.step(alone, dt, sweeps); }); },
                 [&] { return seconds_of([&] { without_sleep.step(alone_without_sleep, dt, sweeps); }); }});
    asleep = std::min(asleep, asleep_in(with_thousand));
  }
  FullSolver full;  // afterwards, because it would empty the cache for the others
  std::vector<double> everything;
  for (int step = 0; step < 120; ++step) everything.push_back(seconds_of([&] { all.step(full, dt, sweeps); }));
  state.counters["asleep"] = static_cast<double>(asleep);
  state.counters["islands"] = islands;
  state.counters["1 with thousand, us"] = 1e6 * turns.time(0);
  state.counters["2 five alone, us"] = 1e6 * turns.time(1);
  state.counters["3 five alone, no sleep, us"] = 1e6 * turns.time(2);
  state.counters["4 all simulated, us"] = 1e6 * median(everything);
  state.counters["with thousand / alone"] = turns.ratio(0, 1);
  state.counters["with thousand / alone, no sleep"] = turns.ratio(0, 2);
  state.counters["all simulated / with thousand"] = median(everything) / turns.time(0);
}
BENCHMARK(thousand_and_five)->ArgName("height")->Arg(1)->Arg(4)->Iterations(150)->Unit(benchmark::kMicrosecond);

/// The cost of the search for sleepers if no body may sleep.
void watching_for_sleepers(benchmark::State& state) {
  World simulated;
  simulated.add(ground());
  thousand(simulated, static_cast<int>(state.range(0)));
  World watched = simulated;
  Sleep sleepless;
  sleepless.time_to_sleep = Real(1e9);
  OnlyWhatIsNeeded without(simulated, FullSolver{}), with(watched, FullSolver{}, sleepless);
  InTurn turns;
  for (auto _ : state) {
    turns.round({[&] { return seconds_of([&] { without.step(simulated, dt, sweeps); }); },
                 [&] { return seconds_of([&] { with.step(watched, dt, sweeps); }); }});
  }
  state.counters["ns per body and step"] = 1e9 * turns.difference(1, 0) / 1000;
  state.counters["with / without"] = turns.ratio(1, 0);
}
BENCHMARK(watching_for_sleepers)->ArgName("height")->Arg(1)->Arg(4)->Iterations(200)->Unit(benchmark::kMicrosecond);

}  // namespace
