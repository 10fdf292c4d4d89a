/// The answer to exercise 22, and its checks.
#pragma once

#include "pushback/common/exercise/exercise.h"

namespace pushback::exercise_22 {

/// Two bodies that touch, by their indices.
struct Pair {
  std::size_t a, b;
};

using Pairs = std::vector<Pair>;
using Movable = std::vector<bool>;  ///< of each body
using Colours = std::vector<int>;   ///< of each pair, from 0 on

struct Answer {
  Colours (*colours)(const Pairs& pairs, const Movable& movable);
};

std::vector<Check<Answer>> checks_of(const Answer& /*any*/);

}  // namespace pushback::exercise_22
