/// What exercise 10 asks for.
#pragma once

#include "pushback/chapters/10_position_correction/correcting_solver.h"
#include "pushback/chapters/10_position_correction/displace.h"
#include "pushback/common/exercise/exercise.h"

namespace pushback::exercise_10 {

inline constexpr Real beta = Real(0.2);
inline constexpr int rounds = 60;

struct Answer {
  void (*correct)(CorrectingContext& step);  ///< once the bodies have moved
};

Numbers play(std::size_t check, Random& random, const Answer& answer);

}  // namespace pushback::exercise_10
