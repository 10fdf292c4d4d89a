/// Every exercise, by chapter; a transfer stands behind the rebuild of its chapter.
#pragma once

#include "pushback/common/exercise/exercise.h"

namespace pushback {

std::vector<Exercise> all_exercises();

}  // namespace pushback
