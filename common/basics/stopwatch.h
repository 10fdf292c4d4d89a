/// Measures the time of this program without the time of others.
#pragma once

#include <algorithm>
#include <chrono>
#include <ctime>

namespace pushback {

/// Runs between go and stop. For each interval it counts the wall time or the CPU time of this thread, whichever is less. Only the wall
/// time includes the time of other programs, and only the CPU time includes the cost of its own query (about 0.2 us).
class Stopwatch {
 public:
  void go() {
    own_since_ = own();
    since_ = std::chrono::steady_clock::now();
  }
  void stop() {
    const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - since_).count();
    seconds_ += std::min(wall, own() - own_since_);
  }
  double seconds() const { return seconds_; }

 private:
  static double own() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
  }
  std::chrono::steady_clock::time_point since_;
  double own_since_ = 0, seconds_ = 0;
};

/// The time that `act()` takes, s.
template <class Act>
double computing_time(const Act& act) {
  Stopwatch watch;
  watch.go();
  act();
  watch.stop();
  return watch.seconds();
}

}  // namespace pushback
