/// What an island calls for, and the substeps that its energy calls for, as plain functions.
#pragma once

#include "pushback/common/basics/types.h"

namespace pushback::plain_26 {

enum class Call { flight, half_steps, substeps };

/// What is known of an island.
struct Seen {
  int contacts = 0;  // that may act in this step
  int joints = 0;
  bool refused = false;         // half steps do not do what is in it: a limit, a loop, a Force
  bool had_half_steps = false;  // in the step before
};

struct Bounds {
  int most = 8, most_kept = 12;                 // contacts of an island of few; of one that was one in the step before
  int least_substeps = 4, most_substeps = 128;  // of joints
};

inline Call call_of(const Seen& island, const Bounds& bounds) {
  if (island.refused) return Call::substeps;
  if (island.contacts == 0) return island.joints > 0 ? Call::half_steps : Call::flight;
  const int most = island.had_half_steps ? bounds.most_kept : bounds.most;
  return island.contacts <= most ? Call::half_steps : Call::substeps;
}

/// What a step that has been tried is worth.
struct Verdict {
  bool stands;   // else it is taken again from where it began
  int substeps;  // of the next try: of the same step, or of the next one; 0: half steps do not get there
};

/// `off`: |dE| of a step in so many substeps, in parts of what is allowed. The error of half steps falls with their square, so
/// what is below an eighth is below a half in half as many.
inline Verdict judge_step(int substeps, Real off, const Bounds& bounds) {
  if (off <= 1) {
    const bool fewer = off < Real(0.125) && substeps > bounds.least_substeps;
    return {true, fewer ? substeps / 2 : substeps};
  }
  return {false, 2 * substeps <= bounds.most_substeps ? 2 * substeps : 0};
}

}  // namespace pushback::plain_26
