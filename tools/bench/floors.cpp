/// How near to what the processor can do the passes of chapter 22 come: pass by pass, the time of a step of 1/60 s beside the least
/// that its operations, and the bytes it reads and writes, could take.
#include <benchmark/benchmark.h>

#include <array>

#include "pushback/chapters/22_wide/passes.h"
#include "pushback/chapters/22_wide/wide.h"
#include "pushback/common/world/situations.h"
#include "pushback/tools/bench/counted.h"
#include "pushback/tools/bench/in_turn.h"
#include "pushback/tools/bench/peaks.h"

using namespace pushback;

namespace {

enum Pass { preparing, aiming, carrying, relaxing, pushing, rubbing, passes };

/// The passes of a processor, each told to `note` with what it did.
template <class Scalar, class Note>
struct Noted {
  static inline Passes<Scalar> of;
  template <Pass pass, class Act>
  static auto noted(const Act& act) {
    if constexpr (std::is_void_v<decltype(act())>) {
      Note::note(pass, act);
    } else {
      decltype(act()) result{};
      Note::note(pass, [&] { result = act(); });
      return result;
    }
  }
  static Passes<Scalar> all(const Passes<Scalar>& plain) {
    using All = Bundles<Scalar>;
    of = plain;
    Passes<Scalar> with = plain;
    with.prepare = [](const All& all) { noted<preparing>([&] { of.prepare(all); }); };
    with.prepare_substep = [](const All& all, const WidePushOut<Scalar>& out) {
      return noted<aiming>([&] { return of.prepare_substep(all, out); });
    };
    with.along = [](const All& all) { noted<carrying>([&] { of.along(all); }); };
    with.relax = [](const All& all) { noted<relaxing>([&] { of.relax(all); }); };
    with.solve_normals = [](const All& all) { return noted<pushing>([&] { return of.solve_normals(all); }); };
    with.solve_friction = [](const All& all) { noted<rubbing>([&] { of.solve_friction(all); }); };
    with.solve_friction_and_sum = [](const All& all) { noted<rubbing>([&] { of.solve_friction_and_sum(all); }); };
    return with;
  }
};

struct Timing {
  static inline std::array<double, passes> seconds;
  template <class Act>
  static void note(Pass pass, const Act& act) {
    seconds[pass] += seconds_of(act);
  }
};
struct Counting {
  static inline std::array<Work, passes> work;
  template <class Act>
  static void note(Pass pass, const Act& act) {
    counted_work = {};
    act();
    work[pass].operations += counted_work.operations;
    work[pass].slow += counted_work.slow;
    work[pass].bytes += counted_work.bytes;
  }
};

/// The passes, one counted lane at a time.
template <class Scalar>
Passes<Scalar> counted_passes() {
  using Lane = Counted<Scalar>;
  return {"counted",
          1,
          prepare<Lane, Scalar>,
          prepare_substep<Lane, Scalar>,
          along<Lane, Scalar>,
          relax<Lane, Scalar>,
          solve_normals<Lane, Scalar>,
          solve_friction<Lane, Scalar>,
          solve_friction_and_sum<Lane, Scalar>,
          save_impulses<Lane, Scalar>,
          restore<Lane, Scalar>,
          nullptr};  // which turns bodies: no pass over contacts
}

constexpr double microsecond = 1e-6;

/// Operations a second, of all lanes.
template <class Scalar>
double most_operations() {
  std::vector<double> rates(51);
  for (double& rate : rates) {
    double operations = 0;
    Scalar sink = 0;
    const double time = seconds_of([&] { operations = multiply_and_add(1 << 15, Scalar(0.5), sink); });
    benchmark::DoNotOptimize(sink);
    rate = operations / time;
  }
  return median(rates);
}

/// Bytes a second, read and written back, of so many bytes again and again.
template <class Scalar>
double most_bytes(std::size_t bytes) {
  std::vector<Eight<Scalar>> memory(bytes / sizeof(Eight<Scalar>));
  std::vector<double> rates(51);
  for (double& rate : rates) {
    const double time = seconds_of([&] { add_to_all(memory.data(), static_cast<long>(memory.size()), Scalar(1)); });
    benchmark::DoNotOptimize(memory.data());
    rate = 2 * static_cast<double>(bytes) / time;
  }
  return median(rates);
}

/// One pass of all those in a step of the pyramid of 210 boxes at rest, 8 substeps.
template <class Scalar, Pass pass>
void pyramid_in_8_substeps(benchmark::State& state) {
  World timed, counted;
  pyramid(timed, 20);
  pyramid(counted, 20);
  Wide<Scalar> timing, counting;
  timing.substeps = counting.substeps = 8;
  timing.passes = Noted<Scalar, Timing>::all(timing.passes);
  counting.passes = Noted<Scalar, Counting>::all(counted_passes<Scalar>());
  for (int i = 0; i < 120; ++i) {
    Counting::work = {};
    timed.step(timing, Real(1) / 60);
    counted.step(counting, Real(1) / 60);
  }
  std::vector<double> times;
  for (auto _ : state) {
    Timing::seconds = {};
    timed.step(timing, Real(1) / 60);
    times.push_back(Timing::seconds[pass]);
  }
  const Work& work = Counting::work[pass];
  const std::size_t memory = timed.contacts.size() / lanes_of_bundle * sizeof(WideContact<Scalar>);
  const double took = median(times), by_operations = work.operations / most_operations<Scalar>(),
               by_bytes = work.bytes / most_bytes<Scalar>(memory);
  state.counters["1 us"] = took / microsecond;
  state.counters["2 by operations"] = by_operations / microsecond;
  state.counters["3 by bytes"] = by_bytes / microsecond;
  const double floor = std::max(by_operations, by_bytes);
  state.counters["4 times the floor"] = floor > 0 ? took / floor : 0;
  state.counters["5 operations"] = work.operations;
  state.counters["6 quotients and roots"] = work.slow;
  state.counters["7 bytes"] = work.bytes;
}
#define PASS(pass)                                                                      \
  BENCHMARK(pyramid_in_8_substeps<float, pass>)->Iterations(300)->Name(#pass "/float"); \
  BENCHMARK(pyramid_in_8_substeps<double, pass>)->Iterations(300)->Name(#pass "/double")
PASS(preparing);
PASS(aiming);
PASS(carrying);
PASS(relaxing);
PASS(pushing);
PASS(rubbing);

}  // namespace
