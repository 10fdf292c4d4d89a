/// Exercise 23: a sweep by several threads. The task is chapters/23_threads/exercise/task.md.
#pragma once

#include "pushback/chapters/23_threads/exercise/asked.h"

namespace student {

using namespace pushback;
using exercise_23::Sizes;
using exercise_23::Thread;

/// What one of the threads does in a sweep. Each of them calls this, with another `thread.who`.
///
/// You read   sizes[s]       how many bundles the set s has; sizes.size() is the number of sets
///            thread.who     which thread this is, from 0 on
///            thread.count   how many there are
/// You call   thread.solve(bundle)     bundles are numbered through all sets: those of set 1 follow those of set 0
///            thread.wait_for_all()    after every set, the last one too
inline void sweep(Thread& thread, const Sizes& sizes) {
  // TODO for each set: this thread's share of its bundles; then wait
  (void)thread, (void)sizes;  // take this line out
  // TODO ends
}

inline const exercise_23::Answer answer{sweep};

}  // namespace student
