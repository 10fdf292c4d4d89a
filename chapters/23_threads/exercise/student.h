/// Exercise 23: a sweep by several threads. The task is chapters/23_threads/exercise/task.md.
#pragma once

#include "pushback/chapters/23_threads/exercise/asked.h"

namespace student {

using namespace pushback;
using exercise_23::Sizes;
using exercise_23::Thread;

/// The work of one thread in a sweep. Each thread calls this function, with another `thread.who`.
///
/// You read   sizes[s]       the number of bundles of set s, where sizes.size() is the number of sets
///            thread.who     the index of this thread, from 0 on
///            thread.count   the number of threads
/// You call   thread.solve(bundle)     bundles are numbered across all sets, so set 1 begins after the last bundle of set 0
///            thread.wait_for_all()    after every set, even after the last
inline void sweep(Thread& thread, const Sizes& sizes) {
  // TODO for each set: solve this thread's share of the bundles, then wait
  (void)thread, (void)sizes;  // take this line out
  // TODO ends
}

inline const exercise_23::Answer answer{sweep};

}  // namespace student
