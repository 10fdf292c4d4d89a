/// Playing all of the table's pairs, on several threads.
#include <atomic>
#include <cmath>
#include <exception>
#include <mutex>
#include <thread>

#include "pushback/common/basics/input.h"
#include "tests/hard_cases/table.h"

namespace pushback {

namespace {

/// The world that the case's picture shows.
World end_of(const HardCase& hard_case, const Stage& stage) {
  World world;
  hard_case.scene.fill(world);
  const Stepper step = stage.begin();
  constexpr Real dt = Real(1) / 60;
  try {
    for (long i = std::lround(hard_case.scene.seconds / dt); i > 0; --i) step(world, dt);
  } catch (const InvalidInput&) {  // no longer finite: as it was until then
  }
  return world;
}

/// Calls work(i) for each i below count, on so many threads; the first exception comes out.
void in_parallel(std::size_t count, int threads, const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next = 0;
  std::exception_ptr problem;
  std::mutex mutex;
  const auto take = [&] {
    for (std::size_t i = next++; i < count; i = next++) {
      try {
        work(i);
      } catch (...) {
        const std::lock_guard lock(mutex);
        if (!problem) problem = std::current_exception();
        next = count;
      }
    }
  };
  std::vector<std::thread> pool;
  for (int i = 1; i < threads; ++i) pool.emplace_back(take);
  take();
  for (std::thread& thread : pool) thread.join();
  if (problem) std::rethrow_exception(problem);
}

}  // namespace

Table play(std::vector<HardCase> cases, std::vector<Stage> stages, int threads, const Progress& progress,
           std::vector<World>* ends) {
  Table table{std::move(cases), std::move(stages), 0, {}};
  for (std::size_t i = 0; i < chapter_stages; ++i) {
    for (const Stage& stage : table.stages) table.chapters += stage.name == pushback::stages()[i].name ? 1 : 0;
  }
  const std::size_t columns = table.stages.size(), pairs = table.cases.size() * columns;
  table.outcomes.resize(pairs);
  if (ends) ends->resize(table.cases.size());
  std::vector<std::size_t> left(table.cases.size(), columns);
  std::size_t rows = 0, done = 0;
  std::mutex mutex;
  in_parallel(pairs + (ends ? table.cases.size() : 0), threads, [&](std::size_t i) {
    if (i >= pairs) {
      (*ends)[i - pairs] = end_of(table.cases[i - pairs], table.stages.back());
      return;
    }
    Outcome outcome = outcome_of(table.cases[i / columns], table.stages[i % columns]);
    const std::lock_guard lock(mutex);
    table.outcomes[i] = std::move(outcome);
    --left[i / columns];
    while (rows < left.size() && left[rows] == 0) ++rows;
    progress(table, rows, ++done);
  });
  return table;
}

}  // namespace pushback
