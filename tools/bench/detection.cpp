/// What detection costs: which pairs are near, and what a near pair takes that touches, or does not.
#include <benchmark/benchmark.h>

#include <algorithm>

#include "pushback/chapters/22_wide/wide.h"
#include "pushback/common/collision/broad_phase.h"
#include "pushback/common/collision/collide.h"
#include "pushback/common/world/situations.h"
#include "pushback/tools/bench/in_turn.h"

using namespace pushback;

namespace {

constexpr Real dt = Real(1) / 60;

/// How far b moves and turns against a from one world to the other: m and rad, added.
Real relative_motion(const World& before, const World& after, const BodyPair& pair) {
  const auto place = [&](const World& world) {
    const Body &a = world.bodies[static_cast<std::size_t>(pair.first)],
               &b = world.bodies[static_cast<std::size_t>(pair.second)];
    return std::pair{Vec3(a.orientation.conjugate() * (b.position - a.position)),
                     Quat(a.orientation.conjugate() * b.orientation)};
  };
  const auto [from, turned_from] = place(before);
  const auto [to, turned_to] = place(after);
  return (to - from).norm() + turned_from.angularDistance(turned_to);
}

/// After 4 s with the wide solver, by the margin that it detects with.
void detected(benchmark::State& state, const std::function<void(World&)>& fill) {
  World world;
  fill(world);
  Wide<float> solver;
  solver.substeps = 8;
  for (int i = 0; i < 240; ++i) world.step(solver, dt);
  const Margin margin{.least = solver.margin, .ahead = dt};
  std::vector<BodyPair> pairs, touching, apart;
  pairs = near_pairs(world.bodies, margin);
  for (const auto& [a, b] : pairs) {
    Contacts found;
    collide(world.bodies[static_cast<std::size_t>(a)], world.bodies[static_cast<std::size_t>(b)], found, margin);
    (found.empty() ? apart : touching).emplace_back(a, b);
  }
  Contacts contacts;
  const auto collided = [&](const std::vector<BodyPair>& those) {
    return [&] {
      contacts.clear();
      return seconds_of([&] {
        for (const auto& [a, b] : those)
          collide(world.bodies[static_cast<std::size_t>(a)], world.bodies[static_cast<std::size_t>(b)], contacts,
                  margin);
      });
    };
  };
  InTurn turns;
  for (auto _ : state)
    turns.round(
        {[&] { return seconds_of([&] { near_pairs(world.bodies, margin); }); }, collided(touching), collided(apart)});
  World after = world;
  after.step(solver, dt);
  const auto still = std::count_if(touching.begin(), touching.end(), [&](const BodyPair& pair) {
    return relative_motion(world, after, pair) < Real(1e-4);
  });
  state.counters["bodies"] = static_cast<double>(world.bodies.size());
  state.counters["near pairs, us"] = 1e6 * turns.time(0);
  state.counters["touching"] = static_cast<double>(touching.size());
  state.counters["of which still"] = static_cast<double>(still);
  state.counters["touching, ns each"] = 1e9 * turns.time(1) / static_cast<double>(touching.size());
  state.counters["apart"] = static_cast<double>(apart.size());
  state.counters["apart, us"] = 1e6 * turns.time(2);
}
BENCHMARK_CAPTURE(detected, pyramid of 210, [](World& world) { pyramid(world, 20); })->Iterations(200);
BENCHMARK_CAPTURE(detected, pile of 512, [](World& world) { heap(world, 8, 8, -4); })->Iterations(100);
BENCHMARK_CAPTURE(detected, pile of 4000, [](World& world) { heap(world, 20, 10, -10); })->Iterations(50);

}  // namespace
