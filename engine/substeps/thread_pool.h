/// Threads that share work whose parts are independent of each other.
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

/// Each thread takes the part of its own number first, then what others have not begun: nobody waits for a thread that sleeps.
/// Parts are computed in the rounding mode of who calls. While it is at work, who calls it from elsewhere does the parts alone.
class ThreadPool : public Workers {
 public:
  static constexpr int most_threads = 256;

  /// So many, of which the one that calls is the first. Throws InvalidInput unless there are 1 to `most_threads`.
  explicit ThreadPool(int threads, bool always_split = false);
  ~ThreadPool() override;
  int threads() const { return static_cast<int>(others_.size()) + 1; }

 protected:
  /// Until every part that somebody has begun is done.
  virtual void wait_for_others();

 private:
  /// On a cache line of its own: who takes one does not slow down who takes the next.
  struct alignas(64) Place {
    std::atomic<unsigned> state = 0;  // 2 n: free in round n; 2 n + 1: taken
    std::exception_ptr failed;
  };
  void share(std::size_t count, const std::function<void(std::size_t)>& act) override;
  void work(std::size_t first);
  void take_parts(std::size_t first, unsigned round);

  std::vector<Place> places_;
  alignas(64) std::atomic<unsigned> round_ = 0;  // of work that is shared; the threads wait for the next
  alignas(64) std::atomic<int> undone_ = 0;      // parts
  std::atomic<bool> ending_ = false;
  std::atomic_flag busy_;

  // Of this round. Who has taken a part may read it: the round cannot end before.
  const std::function<void(std::size_t)>* act_ = nullptr;
  std::fenv_t mode_{};

  int spins_;
  std::vector<std::thread> others_;  // the last: they end before what they use does
};

}  // namespace pushback
