/// Exercise 26: what an island calls for. The task is chapters/26_to_each_its_own/exercise/task.md.
#pragma once

#include "pushback/chapters/26_to_each_its_own/exercise/asked.h"

namespace student {

using namespace pushback;
using exercise_26::Bounds;
using exercise_26::Call;
using exercise_26::Seen;
using exercise_26::Verdict;

/// `call`: how an island is moved in this step, Call::flight, Call::half_steps or Call::substeps.
///
/// You read   island.contacts          that may act in this step
///            island.joints            in an island without contacts
///            island.refused           whether half steps do not do what is in it
///            island.had_half_steps    in the step before
///            bounds.most, .most_kept  contacts of an island of few; of one that was one in the step before
///
/// `judge`: what a step that has been tried is worth, {stands, substeps}.
///
/// You read   substeps                 in which it has been tried
///            off                      |dE| of this try, in parts of what is allowed
///            bounds.least_substeps, .most_substeps
/// You return stands                   whether it stands; else it is taken again from where it began
///            substeps                 of the next try: of the same step, or of the next one; 0: not by half steps

// TODO both functions, in the place of these
inline Call call(const Seen& island, const Bounds& bounds) {
  (void)island, (void)bounds;
  return Call::substeps;
}
inline Verdict judge(int substeps, Real off, const Bounds& bounds) {
  (void)off, (void)bounds;
  return {true, substeps};
}
// TODO ends

inline const exercise_26::Answer answer{call, judge};

}  // namespace student
