/// The answer to exercise 26, and its checks.
#pragma once

#include "pushback/chapters/26_to_each_its_own/plain.h"
#include "pushback/common/exercise/exercise.h"

namespace pushback::exercise_26 {

using plain_26::Bounds;
using plain_26::Call;
using plain_26::Seen;
using plain_26::Verdict;

struct Answer {
  Call (*call)(const Seen& island, const Bounds& bounds);
  Verdict (*judge)(int substeps, Real off, const Bounds& bounds);
};

std::vector<Check<Answer>> checks_of(const Answer& /*any*/);

}  // namespace pushback::exercise_26
