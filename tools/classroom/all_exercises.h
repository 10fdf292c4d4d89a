/// Every exercise, by chapter, the rebuild before the transfer.
#pragma once

#include "pushback/common/exercise/exercise.h"

namespace pushback {

std::vector<Exercise> all_exercises();

}  // namespace pushback
