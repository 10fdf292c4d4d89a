/// Where the time of a step goes, in chapters 21 and 22: medians over the steps, µs.
#include <benchmark/benchmark.h>

#include <array>

#include "pushback/chapters/21_detected_once/detected_once.h"
#include "pushback/common/world/situations.h"
#include "pushback/common/world/step.h"
#include "pushback/engine/substeps/wide_solver.h"
#include "pushback/tools/bench/in_turn.h"

using namespace pushback;

namespace {

enum Phase { detection, rows, substeps_before, relaxing, end, phases };

/// The phases of one step.
std::array<double, phases> spent{};

template <class Act>
void within(Phase phase, const Act& act) {
  spent[phase] += seconds_of(act);
}

template <class Full>
struct Timed : Full {
  void after_detection(World& world, Real h) override {
    within(rows, [&] { Full::after_detection(world, h); });
  }
  void solve(World& world, Real h, int sweeps) override {
    within(substeps_before, [&] { Full::solve(world, h, sweeps); });
  }
  void after_move(World& world, Real h) override {
    within(relaxing, [&] { Full::after_move(world, h); });
  }
  void end_detection(World& world) override {
    within(end, [&] { Full::end_detection(world); });
  }
};
struct AllBodiesTimed : AllBodies {
  static void find_contacts(World& world, const Margin& margin) {
    within(detection, [&] { world.find_contacts(margin); });
  }
};

template <class Full>
void phases_of(benchmark::State& state, World world, int substeps) {
  Timed<Full> solver;
  solver.substeps = substeps;
  AllBodiesTimed all_bodies;
  const auto next = [&] { step(world, solver, Real(1) / 60, 1, all_bodies); };
  for (int i = 0; i < 120; ++i) next();
  std::array<std::vector<double>, phases> times;
  std::vector<double> others, whole;
  for (auto _ : state) {
    spent = {};
    whole.push_back(seconds_of(next));
    others.push_back(whole.back());
    for (int phase = 0; phase < phases; ++phase) {
      times[static_cast<std::size_t>(phase)].push_back(spent[static_cast<std::size_t>(phase)]);
      others.back() -= spent[static_cast<std::size_t>(phase)];
    }
  }
  const std::array names{"1 detection", "2 rows", "3 solving", "4 relaxing", "5 end"};
  for (std::size_t phase = 0; phase < phases; ++phase) state.counters[names[phase]] = 1e6 * median(times[phase]);
  state.counters["6 moving bodies"] = 1e6 * median(others);
  state.counters["all"] = 1e6 * median(whole);
  state.counters["contacts"] = static_cast<double>(world.contacts.size());
}

template <class Full>
void add(const std::string& solver) {
  const auto phases_in = [&](const std::string& name, const std::function<void(World&)>& fill, int substeps,
                             int steps) {
    World world;
    fill(world);
    benchmark::RegisterBenchmark((name + "<" + solver + ">").c_str(), phases_of<Full>, world, substeps)
        ->Iterations(steps);
  };
  phases_in("pyramid_in_8_substeps", [](World& world) { pyramid(world, 20); }, 8, 300);
  phases_in("stack_in_32_substeps", [](World& world) { stack(world, 40); }, 32, 300);
  phases_in("pile_in_8_substeps", [](World& world) { heap(world, 20, 10, -10); }, 8, 120);
}
[[maybe_unused]] const bool added = [] {
  add<DetectedOnce>("DetectedOnce");
  add<WideSolver<double>>("WideSolver<double>");
  add<WideSolver<float>>("WideSolver<float>");
  return true;
}();

}  // namespace
