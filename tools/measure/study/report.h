/// The measurements as diagrams and as tables in Markdown.
#pragma once

#include <chrono>

#include "pushback/common/experiment/plot.h"
#include "pushback/tools/measure/study/rounds.h"

namespace pushback::study {

struct MotionMeasured {
  const Motion* motion;
  Measurements all;
};

// Lines and chosen settings use robust errors, and give the number of settings from which they were chosen.

/// Error against time, with a dot at the own error of each of our settings, and a line through the best settings of each engine.
Panel work_precision(const MotionMeasured& measured, const std::vector<Engine>& engines);

/// The same for the methods of one of our programs, with a line each. "motion" is in double, and "motion_wide" divides steps itself.
Panel fronts_of_methods(const MotionMeasured& measured, const std::string& engine);

/// "For an error below 1 cm, 1 mm, 0.1 mm, 1 µm the cheapest setting is ..., and costs ... us a frame of 1/60 s; its error is ..., of
/// which ... remains as h -> 0."
std::string table_of_cheapest(const std::vector<MotionMeasured>& all);

/// A table with a row per motion. It has the time of a frame and the error of `Recommended` with an error of 1 mm. A column for each
/// maker, with all of the maker's engines, has the cheapest setting below 1 mm and its time for a frame, or the least error reached.
std::string table_of_engines(const std::vector<MotionMeasured>& all, const std::vector<Engine>& engines);

/// The ratio of the other engines' time to ours, for the same four errors.
std::string table_of_others(const std::vector<MotionMeasured>& all, const std::vector<Engine>& engines);

/// The number of motions that ours plays faster than all other engines, for six errors, with all of our settings and with some, and the
/// median factor by which the next engine is slower, for all motions, for motions that are piecewise quadratic or at rest, and for the
/// others.
std::string table_of_regimes(const std::vector<MotionMeasured>& all);
/// A table with a row per motion, with the fastest other engine for each of the six errors, and the ratio of its time to ours.
std::string table_of_next(const std::vector<MotionMeasured>& all);
/// Our least time for 1 cm, 1 mm and 0.1 mm, with and without the methods of chapters 24 to 27.
std::string table_of_half_steps(const std::vector<MotionMeasured>& all);
/// Our least time with contacts detected in each substep, and detected once in 1/60 s.
std::string table_of_once(const std::vector<MotionMeasured>& all);

/// Settings whose own error is below an error of the tables but whose robust error is above it, and the cheapest setting whose robust
/// error is below it, if that setting takes twice as long.
std::string table_of_choices(const std::vector<MotionMeasured>& all);

/// A table with a row per parameter and motion. It has the factors by which a doubling changes error and time, from slopes, and compares
/// warm with cold starts and float with double.
std::string table_of_knobs(const std::vector<MotionMeasured>& all);
/// Error against substeps and against sweeps, for the rows of table_of_knobs.
std::vector<Panel> panels_of_knobs(const std::vector<MotionMeasured>& all);

/// The error of every method that remains as h -> 0, and the order in h of the error that smaller steps remove (limits.h). Similar
/// motions have a common table, such as motions in which bodies move, rest or hang.
std::string table_of_limits(const std::vector<MotionMeasured>& all);

/// The speed, height and error of the first hop by the relaxed law, and the remaining error of MuJoCo.
std::string table_of_hops(const std::vector<MotionMeasured>& all);

// The contents of docs/methods.md, methods of the literature compared with ours.

/// The names of the compared methods, ours first.
const std::vector<std::string>& compared_methods();
/// Error against time, with the front of each compared method in its own colour, from the measurements of all engines for one motion.
Panel fronts_of_compared(const MotionMeasured& measured);
/// A table of errors (mm) with a row per method and a column per motion, for these numbers of substeps and sweeps. Methods without sweeps
/// have the same number of substeps.
std::string table_of_errors(const std::vector<MotionMeasured>& all, int substeps, int sweeps);
/// A table of the same form, with the least time for 1/60 s with a robust error of at most `error` (m), and its setting.
std::string table_of_times(const std::vector<MotionMeasured>& all, double error);

/// The machine, the versions and the load of the measurement, without which a time is meaningless.
struct MachineReport {
  std::string load_before, load_after;
  std::chrono::duration<double> took;
  std::vector<std::string> versions;  ///< of the engines, in the same order
  int resumed = 0;                    ///< number of motions that an earlier, interrupted run had measured
};
/// The machine, the engines, and the number of settings tried for each.
std::string table_of_machine(const MachineReport& run, const std::vector<Engine>& engines, const AllMeasured& all);

}  // namespace pushback::study
