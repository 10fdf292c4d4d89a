/// The cost of a solver: nanoseconds per row and sweep, microseconds per step, bytes per contact.
///
/// The composed solver and the one written by hand are timed in turn within one run. Their ratio counts, since
/// absolute times differ from machine to machine and from minute to minute.
#include <benchmark/benchmark.h>

#include "pushback/chapters/07_warm_start/flat.h"
#include "pushback/chapters/08_friction_cone/scaled_back.h"
#include "pushback/chapters/10_position_correction/study.h"
#include "pushback/chapters/11_substeps/substeps.h"
#include "pushback/chapters/12_soft_contacts/steady_solver.h"
#include "pushback/common/collision/broad_phase.h"
#include "pushback/common/world/situations.h"
#include "pushback/tools/bench/frozen.h"

using namespace pushback;
using namespace pushback::baumgarte_scenes;
using namespace pushback::position_correction_scenes;

namespace {

constexpr Real dt = Real(1) / 60;

template <class ContactSolver>
void solve(benchmark::State& state, int rows_per_contact) {
  FrozenPyramid frozen(static_cast<int>(state.range(0)));
  const int sweeps = static_cast<int>(state.range(1));
  ContactSolver solver;
  for (auto _ : state) state.SetIterationTime(frozen.seconds(solver, sweeps));
  state.counters["contacts"] = frozen.contacts();
  state.counters["per row and sweep"] =
      benchmark::Counter(frozen.contacts() * rows_per_contact * sweeps,
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void composed(benchmark::State& state) {
  solve<FullSolver>(state, 3);
}
void normals_only(benchmark::State& state) {
  solve<Solver<Clamping, Baumgarte, Slop>>(state, 1);
}

// Cost against contacts (a pyramid of base n) and against sweeps: both should grow linearly.
void bases_and_sweeps(benchmark::internal::Benchmark* bench) {
  bench->ArgNames({"base", "sweeps"})->UseManualTime()->Unit(benchmark::kMicrosecond);
  for (const int base : {5, 10, 20, 40}) bench->Args({base, 10});
  for (const int sweeps : {20, 50, 100}) bench->Args({20, sweeps});
}
BENCHMARK(composed)->Apply(bases_and_sweeps);
BENCHMARK(normals_only)->Apply(bases_and_sweeps);

/// Both solvers on the same contacts, in turn, and the median of the ratios.
void composed_against_by_hand(benchmark::State& state) {
  FrozenPyramid frozen(20);
  FullSolver composed_solver;
  flat_07::FlatSolver flat_solver;
  InTurn turns;
  for (auto _ : state) frozen.round(turns, 10, composed_solver, flat_solver);
  state.counters["median ratio"] = turns.ratio(0, 1);
}
BENCHMARK(composed_against_by_hand)->Iterations(400)->Unit(benchmark::kMicrosecond);

/// The cost of chapter 08's ways of friction against chapter 06's, on the same contacts, in turn.
template <class AnyFriction>
void friction_against_pyramid(benchmark::State& state) {
  const int sweeps = static_cast<int>(state.range(0));
  FrozenPyramid frozen(20);
  Solver<Clamping, Baumgarte, Slop, Restitution, AnyFriction, WarmStart> solver;
  FullSolver pyramid_solver;
  InTurn turns;
  for (auto _ : state) frozen.round(turns, sweeps, solver, pyramid_solver);
  state.counters["median ratio"] = turns.ratio(0, 1);
  state.counters["ns per contact and sweep"] = 1e9 * turns.time(0) / (frozen.contacts() * sweeps);
}
void pyramid_of_friction(benchmark::State& state) {
  friction_against_pyramid<Friction>(state);
}
void scaled_back(benchmark::State& state) {
  friction_against_pyramid<FrictionScaledBack>(state);
}
void friction_cone(benchmark::State& state) {
  friction_against_pyramid<FrictionCone>(state);
}
void ten_and_hundred(benchmark::internal::Benchmark* bench) {
  bench->ArgName("sweeps")->Arg(10)->Arg(100)->Iterations(200)->Unit(benchmark::kMicrosecond);
}
BENCHMARK(pyramid_of_friction)->Apply(ten_and_hundred);
BENCHMARK(scaled_back)->Apply(ten_and_hundred);
BENCHMARK(friction_cone)->Apply(ten_and_hundred);

/// The cost of chapter 10's ways to remove overlap against chapter 03's, on the same contacts, in turn. With a slop of 0 every
/// contact is too deep, with one of 20 mm none.
template <class PushOut>
void against_baumgarte(benchmark::State& state) {
  FrozenPyramid frozen(20);
  With<PushOut> solver;
  FullSolver baumgarte;
  solver.slop = baumgarte.slop = static_cast<Real>(state.range(0)) / 1000;
  InTurn turns;
  for (auto _ : state) frozen.round(turns, 10, solver, baumgarte);
  state.counters["median ratio"] = turns.ratio(0, 1);
}
BENCHMARK(against_baumgarte<SplitImpulse>)->ArgName("slop_mm")->Arg(0)->Arg(20)->Iterations(200);
BENCHMARK(against_baumgarte<NonlinearGaussSeidel>)->ArgName("slop_mm")->Arg(0)->Arg(20)->Iterations(200);

template <class Fill>
void whole_step(benchmark::State& state, Fill fill, int settle) {
  World world;
  fill(world);
  FullSolver solver;
  for (int step = 0; step < settle; ++step) world.step(solver, dt, 10);
  for (auto _ : state) world.step(solver, dt, 10);
  state.counters["bodies"] = static_cast<double>(world.bodies.size() - 1);
  state.counters["contacts"] = static_cast<double>(world.contacts.size());
}

void step_of_pyramid(benchmark::State& state) {
  whole_step(state, [](World& world) { pyramid(world, 20); }, 60);
}
BENCHMARK(step_of_pyramid)->Unit(benchmark::kMicrosecond);

/// A whole step of 1/60 s, cut into substeps: contacts, rows and sweeps in each. The tables of chapters 11 and 12.
template <class ContactSolver>
void substeps_of(benchmark::State& state) {
  const int count = static_cast<int>(state.range(0)), sweeps = static_cast<int>(state.range(1));
  const int tall = static_cast<int>(state.range(2));
  World world;
  if (tall > 0) stack(world, tall);
  else pyramid(world, 20);
  Substeps<ContactSolver> solver({}, count, sweeps);
  for (int step = 0; step < 60; ++step) world.step(solver, dt);
  for (auto _ : state) world.step(solver, dt);
  state.counters["contacts"] = static_cast<double>(world.contacts.size());
}
void many_sweeps(benchmark::internal::Benchmark* bench) {
  bench->ArgNames({"steps", "sweeps", "stack"})->Unit(benchmark::kMillisecond);
  for (const int tall : {20, 40, 0}) {  // 0: a pyramid of base 20
    for (const int sweeps : {10, 32}) bench->Args({1, sweeps, tall});
  }
}
void many_steps(benchmark::internal::Benchmark* bench) {
  bench->ArgNames({"steps", "sweeps", "stack"})->Unit(benchmark::kMillisecond);
  for (const int tall : {20, 40, 0}) bench->Args({32, 1, tall});
}
BENCHMARK(substeps_of<FullSolver>)->Apply(many_sweeps)->Apply(many_steps);
BENCHMARK(substeps_of<SoftSolver>)->Apply(many_steps);
BENCHMARK(substeps_of<SteadySolver>)->Apply(many_steps);

void thousand_boxes(World& world) {
  heap(world, 10, 10, Real(-4.5));
}
void step_of_heap(benchmark::State& state) {
  whole_step(state, thousand_boxes, 240);
}
BENCHMARK(step_of_heap)->Unit(benchmark::kMicrosecond);

void find_contacts_of_heap(benchmark::State& state) {
  World world;
  thousand_boxes(world);
  FullSolver solver;
  for (int step = 0; step < 240; ++step) world.step(solver, dt, 10);
  for (auto _ : state) world.find_contacts();
  state.counters["contacts"] = static_cast<double>(world.contacts.size());
}
BENCHMARK(find_contacts_of_heap)->Unit(benchmark::kMicrosecond);

/// As many boxes along each edge of a cube, each near its neighbours.
void near_pairs_of_cube(benchmark::State& state) {
  World world;
  const auto edge = static_cast<int>(state.range(0));
  for (int i = 0; i < edge * edge * edge; ++i)
    world.add(box(Vec3::Constant(Real(0.5)), 1).at(Vec3(i % edge, i / edge % edge, i / edge / edge)));
  std::size_t found = 0;
  for (auto _ : state) found = near_pairs(world.bodies).size();
  state.counters["pairs"] = static_cast<double>(found);
}
BENCHMARK(near_pairs_of_cube)->Arg(5)->Arg(10)->Arg(20)->Arg(40)->Unit(benchmark::kMicrosecond);

/// Not a time, but the memory of a contact, in each form.
void memory_per_contact(benchmark::State& state) {
  for (auto _ : state) benchmark::ClobberMemory();
  state.counters["contact, B"] = sizeof(Contact);
  state.counters["row, B"] = sizeof(Row);
  state.counters["three rows, B"] = 3 * sizeof(Row);
  struct Remembered {
    ContactId id;
    Vec3 impulse;
  };
  state.counters["warm start, B"] = sizeof(Remembered) + sizeof(Vec3);
}
BENCHMARK(memory_per_contact)->Iterations(1);

}  // namespace
