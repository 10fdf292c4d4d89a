/// What each effect costs, and what a scene saves that does without.
///
/// All variants are timed in turn within one run, and counters are medians over the rounds. On frozen contacts every
/// round is the same step: velocities are put back, and the same solver has run just before, so that its rows are at hand.
#include <benchmark/benchmark.h>

#include "pushback/chapters/13_joints/ball_and_socket.h"
#include "pushback/chapters/14_joints_under_load/jointed_solver.h"
#include "pushback/chapters/20_only_what_is_needed/dispatch.h"
#include "pushback/chapters/20_only_what_is_needed/everything.h"
#include "pushback/tools/bench/frozen.h"

using namespace pushback;

namespace {

constexpr Real dt = Real(1) / 60;
constexpr int sweeps = 10;

// ---- the price of each effect of the solver ----------------------------------------------------------------------------

template <class E>
constexpr double own_bytes = 0;  // per contact, in addition to rows
template <>
constexpr double own_bytes<Friction> = sizeof(Real);
template <>
constexpr double own_bytes<WarmStart> = sizeof(Vec3) + 1.0 / 8;

/// `Added` to a solver that has the others already.
template <class Added, class... Others>
void price_of(benchmark::State& state) {
  FrozenPyramid frozen(20);
  Solver<Others...> without;
  Solver<Others..., Added> with;
  InTurn turns;
  for (auto _ : state) frozen.round(turns, sweeps, without, with);
  const double rows = static_cast<double>(with.rows().size() - without.rows().size()) / frozen.contacts();
  state.counters["ns per contact and step"] = 1e9 * turns.difference(1, 0) / frozen.contacts();
  state.counters["ns without"] = 1e9 * turns.time(0) / frozen.contacts();
  state.counters["rows per contact"] = rows;
  state.counters["B per contact"] = rows * sizeof(Row) + own_bytes<Added>;
}
BENCHMARK(price_of<Clamping>)->Iterations(400)->Unit(benchmark::kMicrosecond);
BENCHMARK(price_of<Baumgarte, Clamping>)->Iterations(400)->Unit(benchmark::kMicrosecond);
BENCHMARK(price_of<Slop, Clamping, Baumgarte>)->Iterations(400)->Unit(benchmark::kMicrosecond);
BENCHMARK(price_of<Restitution, Clamping, Baumgarte, Slop>)->Iterations(400)->Unit(benchmark::kMicrosecond);
BENCHMARK(price_of<Friction, Clamping, Baumgarte, Slop, Restitution>)->Iterations(400)->Unit(benchmark::kMicrosecond);
BENCHMARK(price_of<WarmStart, Clamping, Baumgarte, Slop>)->Iterations(400)->Unit(benchmark::kMicrosecond);
BENCHMARK(price_of<WarmStart, Clamping, Baumgarte, Slop, Restitution, Friction>)
    ->Iterations(400)
    ->Unit(benchmark::kMicrosecond);

// ---- the price of what bodies do by themselves ---------------------------------------------------------------------------

/// The difference between two ways to act on each of a thousand boxes, which are put back before every round.
template <class Less, class More>
void price_per_body(benchmark::State& state, const Vec3& half_extents, const Less& less, const More& more) {
  std::vector<Body> before(1000, box(half_extents, 100).spinning({1, 2, 3}));
  std::vector<Body> bodies = before;
  const auto seconds = [&](const auto& act) {
    std::copy(before.begin(), before.end(), bodies.begin());
    return seconds_of([&] {
      for (Body& body : bodies) act(body);
    });
  };
  InTurn turns;
  for (auto _ : state) turns.round({[&] { return seconds(less); }, [&] { return seconds(more); }});
  state.counters["ns per body and step"] = 1e9 * turns.difference(1, 0) / 1000;
  state.counters["ns without"] = 1e9 * turns.time(0) / 1000;
}
void gyroscopic(benchmark::State& state, const Vec3& half_extents) {
  price_per_body(
      state, half_extents, [](Body& body) { spin_evenly(body, dt); }, [](Body& body) { spin_freely(body, dt); });
}
BENCHMARK_CAPTURE(gyroscopic, tumbling, Vec3(Real(0.3), Real(0.4), Real(0.5)))->Iterations(400);
BENCHMARK_CAPTURE(gyroscopic, not_tumbling, Vec3::Constant(Real(0.5)))->Iterations(400);

// ---- the price of the choice ---------------------------------------------------------------------------------------------

void reading_and_choosing(benchmark::State& state) {
  World world;
  pyramid(world, 20);
  for (auto _ : state) benchmark::DoNotOptimize(OnlyWhatIsNeeded(world, FullSolver{}));
}
BENCHMARK(reading_and_choosing)->Unit(benchmark::kMicrosecond);

/// A step with nearly nothing in it, its solver chosen while the program runs and while it was compiled.
void indirect_calls(benchmark::State& state) {
  World world;
  world.gravity.setZero();
  world.add(sphere(Real(0.5), 1).rough(0));
  world.add(sphere(Real(0.5), 1).rough(0).at({9, 0, 0}));
  using Called = Questions<NeedsContacts>;
  OnlyWhatIsNeeded chosen(world, FullSolver{});
  Only<FullSolver, Called> compiled;
  constexpr int steps = 100;
  InTurn turns;
  const auto seconds = [](const auto& step) {
    return [&step] {
      return seconds_of([&] {
        for (int i = 0; i < steps; ++i) step();
      });
    };
  };
  const auto by_compiled = [&] { world.step(compiled, dt, sweeps); };
  const auto by_chosen = [&] { chosen.step(world, dt, sweeps); };
  for (auto _ : state) turns.round({seconds(by_compiled), seconds(by_chosen)});
  state.counters["ns per step"] = 1e9 * turns.difference(1, 0) / steps;
  state.counters["ns without"] = 1e9 * turns.time(0) / steps;
}
BENCHMARK(indirect_calls)->Iterations(400);

// ---- a scene without friction ----------------------------------------------------------------------------------------------

void frictionless_solving(benchmark::State& state) {
  FrozenPyramid frozen(20), rough(20);
  frozen.rubbing(0);
  FittingSolver needed(frozen.world, FullSolver{});
  Solver<Clamping, Baumgarte, Slop, WarmStart> never_heard;
  Solver<Clamping, Baumgarte, Slop, FrictionEverywhere, WarmStart> with_tangents;
  Solver<Clamping, Baumgarte, Slop, Friction, WarmStart> rubbing;
  FullSolver full;
  Everything everything;
  InTurn turns;
  for (auto _ : state) {
    turns.round({[&] { return frozen.seconds(needed); }, [&] { return frozen.seconds(never_heard); },
                 [&] { return frozen.seconds(with_tangents); }, [&] { return rough.seconds(rubbing); },
                 [&] { return frozen.seconds(full); }, [&] { return frozen.seconds(everything); }});
  }
  state.counters["1 needed, us"] = 1e6 * turns.time(0);
  state.counters["2 needed / never heard"] = turns.ratio(0, 1);
  state.counters["3 tangent rows, mu = 0 / needed"] = turns.ratio(2, 0);
  state.counters["4 tangent rows, mu = 0.5 / needed"] = turns.ratio(3, 0);
  state.counters["5 full / needed"] = turns.ratio(4, 0);
  state.counters["6 everything, mu = 0 / needed"] = turns.ratio(5, 0);
}
BENCHMARK(frictionless_solving)->Iterations(400)->Unit(benchmark::kMicrosecond);

// ---- warm starting's cache, where there is none -----------------------------------------------------------------------------

void without_warm_start(benchmark::State& state) {
  FrozenPyramid frozen(20);
  using NeverHad = Solver<Clamping, Baumgarte, Slop, Restitution, Friction>;
  for (Body& body : frozen.world.bodies) body.bouncy(Real(0.1));  // so that the choice leaves nothing else out
  FittingSolver needed(frozen.world, NeverHad{});
  NeverHad never_had;
  InTurn turns;
  for (auto _ : state) frozen.round(turns, sweeps, needed, never_had);
  struct SettingsAndRows : Clamping, Baumgarte, Slop, Restitution, Friction {
    Rows rows;
  };
  state.counters["needed / never had"] = turns.ratio(0, 1);
  state.counters["B beside the rest"] = sizeof(NeverHad) - sizeof(SettingsAndRows);
  state.counters["B with it"] = sizeof(FullSolver) - sizeof(SettingsAndRows);
}
BENCHMARK(without_warm_start)->Iterations(400)->Unit(benchmark::kMicrosecond);

// ---- joints, where there are none -------------------------------------------------------------------------------------------

void without_joints(benchmark::State& state) {
  FrozenPyramid frozen(20);
  FullSolver full;
  JointedSolver jointed;
  for (Body& body : frozen.world.bodies) body.bouncy(Real(0.1));  // so that the choice leaves nothing else out
  FittingSolver needed(frozen.world, jointed);
  InTurn turns;
  for (auto _ : state) frozen.round(turns, sweeps, full, jointed, needed);
  state.counters["full, us"] = 1e6 * turns.time(0);
  state.counters["with joints / full"] = turns.ratio(1, 0);
  state.counters["needed / full"] = turns.ratio(2, 0);
}
BENCHMARK(without_joints)->Iterations(400)->Unit(benchmark::kMicrosecond);

/// The cost of a joint's row, in a chain of balls by itself.
void rows_of_joints(benchmark::State& state) {
  World world;
  for (int i = 0; i <= 100; ++i) {
    const int link = world.add(sphere(Real(0.1), 1).at({0, -Real(0.5) * static_cast<Real>(i), 0}));
    world.joints.push_back(ball_and_socket(world, i == 0 ? the_world : link - 1, link,
                                           {0, Real(0.25) - Real(0.5) * static_cast<Real>(i), 0}));
  }
  Solver<WarmJoints> solver;
  InTurn turns;
  for (auto _ : state) {
    const auto seconds = [&](int count) {
      return [&, count] { return seconds_of([&] { solver.solve(world, dt, count); }); };
    };
    turns.round({seconds(0), seconds(10), seconds(110)});
  }
  const double rows = static_cast<double>(solver.joint_rows().size());
  state.counters["rows"] = rows;
  state.counters["ns per row and sweep"] = 1e9 * turns.difference(2, 1) / (100 * rows);
  state.counters["ns per row to build"] = 1e9 * turns.time(0) / rows;
}
BENCHMARK(rows_of_joints)->Iterations(400)->Unit(benchmark::kMicrosecond);

}  // namespace
