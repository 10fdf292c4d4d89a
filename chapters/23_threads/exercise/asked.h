/// The answer to exercise 23, and its checks.
#pragma once

#include "pushback/common/exercise/exercise.h"

namespace pushback::exercise_23 {

/// One of several threads, as its program sees it. Here nothing runs at the same time. The class records which bundles the
/// thread solves, and between which waits.
class Thread {
 public:
  Thread(int its_who, int of_count) : who(its_who), count(of_count) {}
  const int who;    ///< from 0 on
  const int count;  ///< of all threads

  void solve(int bundle) { done_.back().push_back(bundle); }
  /// Waits until every thread has called this function as often as this thread.
  void wait_for_all() { done_.emplace_back(); }

  /// The bundles that the thread solved before its first wait, between the first and the second, and so on.
  const std::vector<std::vector<int>>& done() const { return done_; }

 private:
  std::vector<std::vector<int>> done_{{}};
};

using Sizes = std::vector<int>;  ///< the number of bundles of each set

struct Answer {
  void (*sweep)(Thread& thread, const Sizes& sizes);
};

std::vector<Check<Answer>> checks_of(const Answer& /*any*/);

}  // namespace pushback::exercise_23
