/// The program that a student's file becomes. It is told which scenes to play, and answers with numbers: nothing that the file
/// does or prints is taken for a verdict.
#pragma once

#include "pushback/common/exercise/exercise.h"

namespace pushback {

/// Of one scene of a check; defined in the one file that includes the student's.
Numbers students_numbers(std::size_t check, Random& random);

}  // namespace pushback
