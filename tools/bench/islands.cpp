/// What each scene costs with one method for all of it, and with each island moved as it calls for.
///
/// Both are timed in turn within one run; counters are medians.
#include <benchmark/benchmark.h>

#include "pushback/chapters/26_to_each_its_own/by_island.h"
#include "pushback/common/basics/input.h"
#include "pushback/tools/bench/in_turn.h"
#include "pushback/tools/catalogue/catalogue.h"

using namespace pushback;

namespace {

/// 10 s in steps of 1/60 s; 5 runs, of each step the median. Of these, how many parts of the bodies' steps were each method's.
void scene(benchmark::State& state, const NamedScene& named) {
  constexpr std::size_t steps = 600, runs = 5;
  constexpr Real dt = Real(1) / 60;
  std::vector<InTurn> turns(steps);
  double moved = 0, flying = 0, in_half_steps = 0;
  try {
    for (auto _ : state) {
      for (std::size_t run = 0; run < runs; ++run) {
        World at_once;
        named.fill(at_once);
        World divided = at_once;
        Wide<Real> one;
        ByIsland own;
        for (InTurn& step : turns) {
          step.round({[&] { return seconds_of([&] { at_once.step(one, dt); }); },
                      [&] { return seconds_of([&] { divided.step(own, dt); }); }});
          for (const Body& body : divided.bodies) {
            if (!body.movable()) continue;
            ++moved;
            flying += own.moved_by(body.index) == MovedBy::flight ? 1 : 0;
            in_half_steps += own.moved_by(body.index) == MovedBy::half_steps ? 1 : 0;
          }
        }
      }
    }
  } catch (const InvalidInput& error) {
    return state.SkipWithError(error.what());
  }
  double one = 0, own = 0;
  for (const InTurn& step : turns) one += step.time(0), own += step.time(1);
  state.counters["1 one method, us"] = 1e6 * one / steps;
  state.counters["2 each its own, us"] = 1e6 * own / steps;
  state.counters["3 its own / one"] = own / one;
  state.counters["4 in flight"] = flying / moved;
  state.counters["5 half steps"] = in_half_steps / moved;
}
[[maybe_unused]] const bool registered = [] {
  for (const NamedScene& named : all_scenes()) {
    benchmark::RegisterBenchmark(("scene/" + named.name).c_str(), scene, named)
        ->Iterations(1)
        ->Unit(benchmark::kMillisecond);
  }
  return true;
}();

}  // namespace
