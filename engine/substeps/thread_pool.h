/// Threads that share work with independent parts.
///
///   WideSolver<float> solver;
///   solver.workers = std::make_shared<ThreadPool>(2);
///   world.step(solver, 1.0 / 60);
#pragma once

#include <atomic>
#include <cfenv>
#include <exception>
#include <memory>
#include <thread>
#include <vector>

#include "pushback/common/basics/workers.h"

namespace pushback {

/// Each thread runs its own parts first, then parts that other threads have not begun, so no thread waits for one that sleeps.
/// Parts run in the rounding mode of the calling thread. If another thread calls the pool while it is at work, that thread runs
/// its parts by itself.
class ThreadPool : public Workers {
 public:
  static constexpr int most_threads = 256;

  /// `threads`: 1 to `most_threads`, including the calling thread. Throws InvalidInput for others. `always_split`: see Workers.
  explicit ThreadPool(int threads, bool always_split = false);
  ~ThreadPool();
  int threads() const { return static_cast<int>(others_.size()) + 1; }

 protected:
  /// Returns when all parts are done.
  virtual void wait_for_others();

 private:
  /// The state of a part. Each has a cache line of its own, so that threads that take different parts do not slow each other
  /// down.
  struct alignas(64) Place {
    std::atomic<unsigned> state = 0;  // 2 n if free in round n, 2 n + 1 if taken
    std::exception_ptr failed;
  };
  void share(std::size_t count, const std::function<void(std::size_t)>& act) override;
  void work(std::size_t first);
  void take_parts(std::size_t first, unsigned round);

  std::vector<Place> places_;
  alignas(64) std::atomic<unsigned> round_ = 0;  // the number of calls of `share`, which the threads wait for
  alignas(64) std::atomic<int> undone_ = 0;      // number of parts that are not done
  std::atomic<bool> ending_ = false;
  std::atomic_flag busy_;

  // The data of this round. A thread may read these while it runs a part, because the round ends later.
  const std::function<void(std::size_t)>* act_ = nullptr;
  std::fenv_t mode_{};

  int spins_;
  std::vector<std::thread> others_;  // the last member, so that the threads end before the members that they use
};

}  // namespace pushback
