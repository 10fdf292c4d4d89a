/// Time that is this program's own.
#pragma once

#include <algorithm>
#include <chrono>
#include <ctime>

namespace pushback {

/// Runs between go and stop, and at no other time. Of each stretch it counts the wall's time or this thread's own, whichever
/// is less: another program's turn is in the first only, what it costs to ask (some 0.2 us) in the second.
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

}  // namespace pushback
