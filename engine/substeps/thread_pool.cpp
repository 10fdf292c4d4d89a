#include "pushback/engine/substeps/thread_pool.h"

#include "pushback/common/basics/input.h"

#ifdef __SSE__
#include <xmmintrin.h>
#endif

namespace pushback {

namespace {

void pause() {
#ifdef __SSE__
  _mm_pause();  // lets the other thread of the core run
#endif
}

/// Returns when the value has changed. Spins for a while, then sleeps.
template <class Value>
void wait_while(const std::atomic<Value>& is, Value value, int spins) {
  for (int i = 0; i < spins; ++i) {
    if (is.load(std::memory_order_acquire) != value) return;
    pause();
  }
  is.wait(value, std::memory_order_acquire);
}

int checked(int threads) {
  if (threads < 1 || threads > ThreadPool::most_threads)
    throw InvalidInput(fmt::format("the number of threads is {}: a whole number from 1 to {} is needed", threads,
                                   ThreadPool::most_threads));
  return threads;
}

/// More than one, so that a thread that is done early can take parts of others.
constexpr std::size_t parts_a_thread = 4;

/// About 0.1 ms if each thread has a core. Otherwise 0, because spinning would take the core from the thread that is waited
/// for.
int spins_of(int threads) {
  return threads <= static_cast<int>(std::thread::hardware_concurrency()) ? 4000 : 0;
}

}  // namespace

ThreadPool::ThreadPool(int threads, bool always_split)
    : Workers(checked(threads) == 1 ? 1 : parts_a_thread * static_cast<std::size_t>(threads), always_split),
      places_(parts_a_thread * static_cast<std::size_t>(threads)),
      spins_(spins_of(threads)) {
  for (std::size_t first = parts_a_thread; first < places_.size(); first += parts_a_thread)
    others_.emplace_back([this, first] { work(first); });
}

ThreadPool::~ThreadPool() {
  ending_ = true;
  ++round_;
  round_.notify_all();
  for (std::thread& other : others_) other.join();
}

void ThreadPool::share(std::size_t count, const std::function<void(std::size_t)>& act) {
  if (busy_.test_and_set(std::memory_order_acquire)) {
    for (std::size_t k = 0; k < count; ++k) act(k);
    return;
  }
  act_ = &act;
  std::fegetenv(&mode_);
  undone_.store(static_cast<int>(count), std::memory_order_relaxed);
  const unsigned round = round_.load(std::memory_order_relaxed) + 1;
  for (std::size_t k = 0; k < count; ++k) {
    places_[k].failed = nullptr;
    places_[k].state.store(2 * round, std::memory_order_release);
  }
  round_.store(round, std::memory_order_release);
  round_.notify_all();
  take_parts(0, round);
  wait_for_others();
  std::exception_ptr failed;
  for (std::size_t k = count; k-- > 0;)
    if (places_[k].failed) failed = places_[k].failed;
  busy_.clear(std::memory_order_release);
  if (failed) std::rethrow_exception(failed);
}

void ThreadPool::wait_for_others() {
  for (int left = undone_.load(std::memory_order_acquire); left > 0; left = undone_.load(std::memory_order_acquire))
    wait_while(undone_, left, spins_);
}

/// Runs the thread's own parts, then all parts that no thread has begun.
void ThreadPool::take_parts(std::size_t first, unsigned round) {
  bool in_mode = first == 0;
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const std::size_t k = (first + i) % places_.size();
    unsigned free = 2 * round;
    if (places_[k].state.load(std::memory_order_relaxed) != free) continue;
    if (!places_[k].state.compare_exchange_strong(free, free + 1, std::memory_order_acq_rel)) continue;
    if (!in_mode) std::fesetenv(&mode_);
    in_mode = true;
    try {
      (*act_)(k);
    } catch (...) {
      places_[k].failed = std::current_exception();
    }
    if (undone_.fetch_sub(1, std::memory_order_acq_rel) == 1) undone_.notify_one();
  }
}

void ThreadPool::work(std::size_t first) {
  unsigned round = 0;
  while (true) {
    wait_while(round_, round, spins_);
    round = round_.load(std::memory_order_acquire);
    if (ending_) return;
    take_parts(first, round);
  }
}

}  // namespace pushback
