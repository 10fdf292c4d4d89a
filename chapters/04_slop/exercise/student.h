/// Exercise 04: slop. The task is chapters/04_slop/exercise/task.md.
#pragma once

#include "pushback/chapters/04_slop/exercise/asked.h"

namespace student {

using namespace pushback;

/// A little overlap is left alone, so that contacts survive.
///
/// You read and change   step.rows[i].separation   C, m: negative where the bodies overlap. Whatever makes a bias of C
///                                                 finds what you leave there.
struct Allowance : Effect {
  Real slop = Real(0.005);  // m

  void adjust_separation(StepContext& step) {
    // TODO for each of the step.contacts.size() normal rows: the separation that counts (the equation of the page)
    (void)step;  // take this line out
    // TODO ends
  }
};

inline const exercise_04::Answer answer{Allowance{}};

}  // namespace student
