/// Exercise 04: a margin that keeps points which are still apart. The task is chapters/04_slop/exercise/task.md.
#pragma once

#include "pushback/chapters/04_slop/exercise/asked.h"

namespace student {

using namespace pushback;

/// Sets the bias of a contact point for a step of h seconds. The bodies may still be apart, because contacts exist as soon as
/// the bodies are closer than the margin.
///
/// You read   normal.separation   C, m, positive if the bodies are apart, negative if they overlap
/// and set    normal.bias         b, m/s, 0 before the call. The row makes J V + b >= 0, and only pushes
inline void set_bias(Row& normal, Real beta, Real slop, Real h) {
  // TODO if apart, the bodies may close the gap within this step, but no more. If overlapping, use the bias of chapter 04
  (void)normal, (void)beta, (void)slop, (void)h;  // take this line out
  // TODO ends
}

inline const exercise_04::Answer answer{set_bias};

}  // namespace student
