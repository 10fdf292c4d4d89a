/// What exercise 23 asks for.
#pragma once

#include "pushback/common/exercise/exercise.h"

namespace pushback::exercise_23 {

/// One of several threads, as its program sees it. Nothing runs at the same time here: what each thread does, and between which of
/// its waits, is written down.
class Thread {
 public:
  Thread(int its_who, int of_count) : who(its_who), count(of_count) {}
  const int who;    ///< from 0 on
  const int count;  ///< of all threads

  void solve(int bundle) { done_.back().push_back(bundle); }
  /// Until every thread has called this as often as this one.
  void wait_for_all() { done_.emplace_back(); }

  /// The bundles that it solved before its first wait, between that and the second, and so on.
  const std::vector<std::vector<int>>& done() const { return done_; }

 private:
  std::vector<std::vector<int>> done_{{}};
};

using Sizes = std::vector<int>;  ///< of the sets: how many bundles each has

struct Answer {
  void (*sweep)(Thread& thread, const Sizes& sizes);
};

std::vector<Check<Answer>> checks_of(const Answer& /*any*/);

}  // namespace pushback::exercise_23
