/// What docs/methods.md shows: methods of the literature, and ours beside them.
#pragma once

#include "pushback/tools/measure/study/report.h"

namespace pushback::study {

/// The methods that are compared, ours first.
const std::vector<std::string>& compared_methods();

/// Error against time, the front of each method in its own colour, from what all engines have measured of one motion.
Panel fronts_of_compared(const MotionMeasured& measured);

/// Errors, mm, a row a method and a column a motion, in so many substeps and sweeps; of methods without sweeps in so many substeps.
std::string table_of_errors(const std::vector<MotionMeasured>& all, int substeps, int sweeps);

/// The least time for 1/60 s with a robust error of at most `error`, m, and its setting, likewise.
std::string table_of_times(const std::vector<MotionMeasured>& all, double error);

}  // namespace pushback::study
