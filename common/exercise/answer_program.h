/// The program into which a student's file is compiled. It plays the checks' scenes and prints the measured numbers. Nothing that the
/// file does or prints counts as a verdict.
#pragma once

#include "pushback/common/exercise/exercise.h"

namespace pushback {

/// The numbers that one scene of a check measures. Defined in the only file that includes the student's.
Numbers students_numbers(std::size_t check, Random& random);

}  // namespace pushback
