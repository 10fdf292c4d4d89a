/// Exercise 22: pairs that may be solved side by side. The task is chapters/22_wide/exercise/task.md.
#pragma once

#include <bit>
#include <cstdint>

#include "pushback/chapters/22_wide/exercise/asked.h"

namespace student {

using namespace pushback;
using exercise_22::Colours;
using exercise_22::Movable;
using exercise_22::Pairs;

/// Returns the colour of each pair, in the order of the pairs, which is the first colour that neither of its bodies has yet.
///
/// You read   pairs[i].a, pairs[i].b   the indices of the bodies of pair i
///            movable[a]               whether body a can move, where movable.size() is the number of bodies
/// No body is in more than 60 pairs.
inline Colours colours(const Pairs& pairs, const Movable& movable) {
  Colours colours(pairs.size(), 0);
  // TODO for each pair: find the first colour that is free in both bodies, and mark it as taken in both
  (void)movable;  // take this line out
  // TODO ends
  return colours;
}

inline const exercise_22::Answer answer{colours};

}  // namespace student
