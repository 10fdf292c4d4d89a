/// ./course grade --hard-cases: where a class stands in the hard cases.
#pragma once

#include "pushback/tools/classroom/grade.h"

namespace pushback {

/// Plays every hard case with each student's solver, in a sandbox as `grading` says, and leaves table.csv, table.md and
/// overview.png in `grading.out`/hard_cases: a column for each student whose solver compiles, beside those of chapters 00 to 08. Prints how many
/// cases each passes. Students may write what they like into their own column: it is for comparison, not for points.
/// A file among the folders of a class is left out, as in grade().
void play_class(const Grading& grading);

}  // namespace pushback
