/// The choice of a step for an island, and of its substeps by its energy, as plain functions.
#pragma once

#include "pushback/common/basics/types.h"

namespace pushback::plain_26 {

enum class Call { flight, half_steps, substeps };

/// The properties of an island that determine its step.
struct Seen {
  int contacts = 0;  // that may act in this step
  int joints = 0;
  bool refused = false;         // half steps do not support its contents: a limit, a loop, a Force
  bool had_half_steps = false;  // in the step before
};

struct Bounds {
  int most = 8, most_kept = 12;  // of contacts for half steps, and if it had half steps in the previous step
  int least_substeps = 4, most_substeps = 128;  // of an island with joints
};

inline Call call_of(const Seen& island, const Bounds& bounds) {
  if (island.refused) return Call::substeps;
  if (island.contacts == 0) return island.joints > 0 ? Call::half_steps : Call::flight;
  const int most = island.had_half_steps ? bounds.most_kept : bounds.most;
  return island.contacts <= most ? Call::half_steps : Call::substeps;
}

/// The assessment of a step that was tried.
struct Verdict {
  bool stands;   // whether the step is accepted; if not, it is repeated from its start
  int substeps;  // of the next try, for the same step or the next one; 0: half steps are not enough
};

/// `off`: |dE| of a step in `substeps` substeps, relative to the allowed error. The error of half steps falls with the square of their
/// number, so an error below an eighth stays below a half with half as many.
inline Verdict judge_step(int substeps, Real off, const Bounds& bounds) {
  if (off <= 1) {
    const bool fewer = off < Real(0.125) && substeps > bounds.least_substeps;
    return {true, fewer ? substeps / 2 : substeps};
  }
  return {false, 2 * substeps <= bounds.most_substeps ? 2 * substeps : 0};
}

}  // namespace pushback::plain_26
