/// Chapters 12, 21 and 22, and the recommended solver, against Bullet's default (float, 10 sweeps), on the same scenes, in steps of
/// 1/60 s, timed in turn within one run. Compiled again for Box3D's (float, 4 substeps) and Jolt's (float, 10 sweeps): what PEER
/// names, by the first of its methods.
#include <benchmark/benchmark.h>

#include "pushback/chapters/21_detected_once/study.h"
#include "pushback/common/bodies/random.h"
#include "pushback/common/world/any_solver.h"
#include "pushback/common/world/measure.h"
#include "pushback/common/world/situations.h"
#include "pushback/engine/presets.h"
#include "pushback/engine/substeps/wide_solver.h"
#include "pushback/tools/bench/in_turn.h"
#include "pushback/tools/measure/peers/peer.h"

using namespace pushback;

namespace {

constexpr Real dt = Real(1) / 60;
const std::string peer = PEER;

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

/// How far the body has moved sideways that has moved farthest, m.
Real drift(const World& start, const World& now) {
  Real most = 0;
  for (std::size_t i = 0; i < now.bodies.size(); ++i) {
    const Vec3 way = now.bodies[i].position - start.bodies[i].position;
    most = std::max(most, std::hypot(way.x(), way.z()));
  }
  return most;
}

/// Medians of the ratios to the peer's time for the same step, ns a contact; how deep contacts are at the end and how far bodies have
/// moved sideways, mm.
void beside_peer(benchmark::State& state, const std::function<void(World&)>& fill, int substeps, int settle) {
  const std::vector<Way> ways{{"chapter 12", detected_once_scenes::DetectedInEach{}, substeps},
                              {"once", in<DetectedOnce>(substeps), 1},
                              {"wide, double", in<WideSolver<double>>(substeps), 1},
                              {"wide, float", in<WideSolver<float>>(substeps), 1},
                              {"recommended", Recommended{}, 1}};
  Motion motion{.name = "", .title = "", .fill = fill, .seconds = 1, .truth = {}};
  const Setting as_it_comes{.substeps = PEER_SUBSTEPS, .sweeps = 10};
  MotionRun run(motion, peer_methods().front(), as_it_comes);
  World start;
  fill(start);
  std::vector<World> worlds(ways.size(), start);
  std::vector<AnySolver> solvers;
  std::vector<std::function<double()>> things{[&] { return seconds_of([&] { run.frame(); }); }};
  for (const Way& way : ways) solvers.push_back(way.solver);
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
  state.counters[peer + ", us"] = 1e6 * turns.time(0);
  for (std::size_t i = 0; i < ways.size(); ++i) {
    state.counters[std::string(ways[i].name) + " / " + peer] = turns.ratio(i + 1, 0);
    worlds[i].find_contacts();
    state.counters[std::string(ways[i].name) + ", mm"] = 1000 * deepest_overlap(worlds[i]);
    state.counters[std::string(ways[i].name) + ", drift mm"] = 1000 * drift(start, worlds[i]);
    const auto contacts = static_cast<double>(worlds[i].contacts.size());
    state.counters["contacts"] = contacts;
    state.counters[std::string(ways[i].name) + ", ns a contact"] = 1e9 * turns.time(i + 1) / contacts;
  }
}

/// Each box aside by up to 3 mm.
void crooked_stack(World& world) {
  stack(world, 40);
  Random random(1);
  for (Body& body : world.bodies)
    if (body.movable()) body.position += random.vector(Real(3e-3)).cwiseProduct(Vec3(1, 0, 1));
}
void columns_of_ten(World& world) {
  world.add(ground());
  for (int i = 0; i < 400; ++i)
    world.add(box(Vec3::Constant(Real(0.5)), 1).at({2 * Real(i / 10), Real(0.5) + Real(i % 10), 0}));
}
[[maybe_unused]] const bool added = [] {
  const auto add = [](const std::string& name, const std::function<void(World&)>& fill, int substeps, int settle,
                      int steps) {
    benchmark::RegisterBenchmark(name.c_str(), beside_peer, fill, substeps, settle)
        ->Iterations(steps)
        ->Unit(benchmark::kMicrosecond);
  };
  const auto pyramid_of_210 = [](World& world) { pyramid(world, 20); };
  const auto stack_of_40 = [](World& world) { stack(world, 40); };
  add("pyramid_of_210", pyramid_of_210, 8, 300, 200);
  add("pyramid_of_210_in_4_substeps", pyramid_of_210, 4, 300, 200);
  add("pyramid_of_210_as_recommended", pyramid_of_210, WideSolver<Real>{}.substeps, 120, 60);
  add("stack_of_40", stack_of_40, 32, 120, 200);
  add("stack_of_40_in_8_substeps", stack_of_40, 8, 600, 100);
  add("crooked_stack_of_40", crooked_stack, 8, 600, 100);
  add("columns_of_ten", columns_of_ten, 8, 300, 100);
  add("pile_of_512", [](World& world) { heap(world, 8, 8, -4); }, 8, 240, 60);
  add("pile_of_4000", [](World& world) { heap(world, 20, 10, -10); }, 8, 240, 20);
  return true;
}();

}  // namespace
