#include <algorithm>
#include <map>
#include <numeric>

#include "pushback/chapters/23_threads/exercise/asked.h"
#include "pushback/tools/classroom/checks/scenes.h"

namespace pushback::exercise_23 {

namespace {

/// Several sets whose sizes cannot be divided evenly. One has fewer bundles than there are threads.
struct Work {
  int threads;
  Sizes sizes;
  int bundles() const { return std::accumulate(sizes.begin(), sizes.end(), 0); }
};
Work some_work(Random& random) {
  Work work{.threads = 4, .sizes = {}};
  for (int set = 0; set < 5; ++set) work.sizes.push_back(set == 2 ? 2 : 4 * whole(random, 2, 5) + 3);
  return work;
}

std::vector<Thread> threads_of(const Answer& answer, const Work& work) {
  std::vector<Thread> threads;
  for (int who = 0; who < work.threads; ++who) {
    threads.emplace_back(who, work.threads);
    answer.sweep(threads.back(), work.sizes);
  }
  return threads;
}
/// Calls act(bundle, phase) for all solved bundles. In each phase the last thread comes first.
template <class Act>
void each_solved(const std::vector<Thread>& threads, const Act& act) {
  std::size_t phases = 0;
  for (const Thread& thread : threads) phases = std::max(phases, thread.done().size());
  for (std::size_t phase = 0; phase < phases; ++phase) {
    for (std::size_t who = threads.size(); who-- > 0;) {
      if (phase >= threads[who].done().size()) continue;
      for (const int bundle : threads[who].done()[phase]) act(bundle, phase);
    }
  }
}

std::size_t set_of(int bundle, const Sizes& sizes) {
  std::size_t set = 0;
  for (; set < sizes.size() && bundle >= sizes[set]; ++set) bundle -= sizes[set];
  return set;
}
/// The bundles of the busiest thread, from wait to wait, added up.
Real busiest(const std::vector<Thread>& threads) {
  std::vector<std::size_t> most;
  for (const Thread& thread : threads) {
    most.resize(std::max(most.size(), thread.done().size()), 0);
    for (std::size_t phase = 0; phase < thread.done().size(); ++phase)
      most[phase] = std::max(most[phase], thread.done()[phase].size());
  }
  return static_cast<Real>(std::accumulate(most.begin(), most.end(), std::size_t(0)));
}

/// Balls of 1 kg in a row, m/s. A bundle is a pair of neighbours that take on their common velocity. Sets of even number have
/// the pairs (0, 1), (2, 3) and on, and the others (1, 2), (3, 4) and on. All sets have the same size.
void collide(std::vector<Real>& velocities, const std::vector<Thread>& threads, const Work& work) {
  each_solved(threads, [&](int bundle, std::size_t) {
    if (bundle < 0 || bundle >= work.bundles()) return;
    const int set = bundle / work.sizes[0], pair = bundle % work.sizes[0];
    const auto a = 2 * static_cast<std::size_t>(pair) + static_cast<std::size_t>(set % 2);
    velocities[a] = velocities[a + 1] = (velocities[a] + velocities[a + 1]) / 2;
  });
}

/// The page's division.
void right(Thread& thread, const Sizes& sizes) {
  int first = 0;
  for (const int size : sizes) {
    const int begin = size * thread.who / thread.count, end = size * (thread.who + 1) / thread.count;
    for (int i = begin; i < end; ++i) thread.solve(first + i);
    thread.wait_for_all();
    first += size;
  }
}

}  // namespace

std::vector<Check<Answer>> checks_of(const Answer& /*any*/) {
  return {
      {"each bundle is solved exactly once", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Work work = some_work(random);
         std::map<int, int> times;
         int all = 0;
         each_solved(threads_of(answer, work), [&](int bundle, std::size_t) { ++times[bundle], ++all; });
         return {{"the number of bundles that some thread solves is", times.size()},
                 {"the total number of times that bundles are solved is", all}};
       },
       "exactly one thread solves each bundle, once. A thread has its own share of each set, and bundle numbers "
       "continue from set to set."},
      {"no thread begins a set before all threads have finished the previous one", 2,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Work work = some_work(random);
         const std::vector<Thread> threads = threads_of(answer, work);
         int in_time = 0;
         std::size_t waits = 0;
         each_solved(threads, [&](int bundle, std::size_t phase) { in_time += set_of(bundle, work.sizes) == phase; });
         for (const Thread& thread : threads) waits += thread.done().size() - 1;
         return {{"the number of bundles solved in the phase of their set is", in_time},
                 {"the total number of waits of your threads is", waits}};
       },
       "bundles of different sets share bodies. So all threads wait after each set, including the last one, even if "
       "their share is empty. They do not wait within a set."},
      {"no thread does more than its share", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         return {{"the bundles of the busiest thread in each phase add up to",
                  busiest(threads_of(answer, some_work(random)))}};
       },
       "all threads wait for the busiest one. The shares of a set differ by at most one bundle."},
      {"balls in a row move as with one thread", 1,
       [](Random& random, const Answer& answer) -> std::vector<Reading> {
         const Work work{.threads = 3, .sizes = Sizes(4, 7 + 3 * whole(random, 0, 2))};
         std::vector<Real> velocities;
         for (int i = 0; i < 2 * work.sizes[0] + 1; ++i) velocities.push_back(random.between(-1, 1));
         collide(velocities, threads_of(answer, work), work);
         Real energy = 0;
         for (const Real velocity : velocities) energy += velocity * velocity / 2;
         return {{"the kinetic energy of your balls is", energy, "J", 1e-9},
                 {"your ball in the middle ends at", velocities[velocities.size() / 2], "m/s", 1e-9}};
       },
       "the velocities differ from those of one thread if a bundle is left out, is solved twice, or is solved too "
       "early."},
  };
}

Exercise exercise() {
  return rebuild_of("a sweep by several threads",
                    {"Go through the sets in their order, and keep track of the number of each set's first bundle.",
                     "In a set with n bundles, this thread solves bundles n who / count up to but excluding n (who + "
                     "1) / count, counted from the first bundle of the set.",
                     "Then call thread.wait_for_all() in every set, even if this thread had nothing to do."},
                    Answer{right});
}

}  // namespace pushback::exercise_23
