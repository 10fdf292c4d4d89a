/// Playing all of the table's pairs, on several threads.
#include <atomic>
#include <future>
#include <mutex>

#include "pushback/common/basics/input.h"
#include "pushback/tools/measure/hard_cases/apart.h"
#include "pushback/tools/measure/hard_cases/table.h"

namespace pushback {

namespace {

/// Calls work(i) for each i below count, on so many threads; an exception comes out.
void in_parallel(std::size_t count, int threads, const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next = 0;
  const auto take = [&] {
    try {
      for (std::size_t i = next++; i < count; i = next++) work(i);
    } catch (...) {
      next = count;
      throw;
    }
  };
  std::vector<std::future<void>> others;
  for (int i = 1; i < threads; ++i) others.push_back(std::async(std::launch::async, take));
  take();
  for (std::future<void>& other : others) other.get();
}

}  // namespace

const Outcome* Table::find(const std::string& name, const std::string& stage) const {
  for (std::size_t row = 0; row < cases.size(); ++row) {
    for (std::size_t column = 0; column < stages.size(); ++column)
      if (cases[row].name == name && stages[column].name == stage && played(row, column)) return &at(row, column);
  }
  return nullptr;
}

Table renewed(const Table& before, const Table& now, std::vector<Stage> stages) {
  Table table = empty_table(hard_cases(), std::move(stages));
  for (std::size_t pair = 0; pair < table.outcomes.size(); ++pair) {
    const std::string &name = table.cases[pair / table.stages.size()].name,
                      &stage = table.stages[pair % table.stages.size()].name;
    const Outcome* outcome = now.find(name, stage);
    if (!outcome) outcome = before.find(name, stage);
    if (!outcome) throw InvalidInput(fmt::format("{} was never played under {}: name it, too", name, stage));
    table.outcomes[pair] = *outcome;
  }
  return table;
}

Table play(std::vector<HardCase> cases, std::vector<Stage> stages, int threads, const Progress& progress,
           const GivingUp& giving_up, const Shard& shard) {
  Table table = empty_table(std::move(cases), std::move(stages));
  const std::size_t columns = table.stages.size(), pairs = table.cases.size() * columns;
  std::vector<std::size_t> left(table.cases.size());
  for (std::size_t i = 0; i < pairs; ++i) left[i / columns] += shard.has(i) ? 1 : 0;
  std::size_t rows = 0, done = 0;
  std::mutex mutex;
  std::atomic<int> given_up = 0;
  in_parallel(pairs, threads, [&](std::size_t i) {
    if (!shard.has(i)) return;
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
