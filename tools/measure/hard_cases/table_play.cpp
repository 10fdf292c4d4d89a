/// Playing all of the table's pairs, on several threads.
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>

#include "pushback/common/basics/input.h"
#include "pushback/tools/measure/hard_cases/apart.h"
#include "pushback/tools/measure/hard_cases/table.h"

namespace pushback {

namespace {

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

void take_over(Table& into, const Table& from) {
  for (std::size_t row = 0; row < from.cases.size(); ++row) {
    for (std::size_t column = 0; column < from.stages.size(); ++column) {
      for (std::size_t pair = 0; pair < into.outcomes.size(); ++pair) {
        if (into.cases[pair / into.stages.size()].name == from.cases[row].name &&
            into.stages[pair % into.stages.size()].name == from.stages[column].name)
          into.outcomes[pair] = from.at(row, column);
      }
    }
  }
}

}  // namespace

Table renewed(const Table& before, const Table& now, std::vector<Stage> stages) {
  Table table = empty_table(hard_cases(), std::move(stages));
  take_over(table, before);
  take_over(table, now);
  for (std::size_t pair = 0; pair < table.outcomes.size(); ++pair) {
    if (table.outcomes[pair].numbers.empty())
      throw InvalidInput(fmt::format("{} was never played under {}: name it, too",
                                     table.cases[pair / table.stages.size()].name,
                                     table.stages[pair % table.stages.size()].name));
  }
  return table;
}

Table play(std::vector<HardCase> cases, std::vector<Stage> stages, int threads, const Progress& progress,
           const GivingUp& giving_up) {
  Table table = empty_table(std::move(cases), std::move(stages));
  const std::size_t columns = table.stages.size(), pairs = table.cases.size() * columns;
  std::vector<std::size_t> left(table.cases.size(), columns);
  std::size_t rows = 0, done = 0;
  std::mutex mutex;
  std::atomic<int> given_up = 0;
  in_parallel(pairs, threads, [&](std::size_t i) {
    const HardCase& hard_case = table.cases[i / columns];
    const Stage& stage = table.stages[i % columns];
    Outcome outcome =
        stage.apart.empty() ? outcome_of(hard_case, stage)
        : given_up < giving_up.times
            ? outcome_apart(hard_case, stage, giving_up.seconds)
            : without_end(hard_case, fmt::format("not played: {} cases before it had no end", given_up.load()));
    given_up += outcome.broken.starts_with(no_end) ? 1 : 0;
    const std::lock_guard lock(mutex);
    table.outcomes[i] = std::move(outcome);
    --left[i / columns];
    while (rows < left.size() && left[rows] == 0) ++rows;
    progress(table, rows, ++done);
  });
  return table;
}

}  // namespace pushback
