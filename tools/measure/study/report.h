/// What was measured, as diagrams and as tables in Markdown.
#pragma once

#include <chrono>

#include "pushback/common/experiment/plot.h"
#include "pushback/tools/measure/study/rounds.h"

namespace pushback::study {

struct MotionMeasured {
  const Motion* motion;
  Measurements all;
};

// Lines, and settings that are chosen, are of robust errors, and say of how many settings they were chosen.

/// Error against time: every setting of ours a dot at its own error, through the best of each engine a line.
Panel work_precision(const MotionMeasured& measured, const std::vector<Engine>& engines);

/// The same of the methods of one program of ours, one line each: "motion", in double; "motion_wide", which divides steps itself.
Panel fronts_of_methods(const MotionMeasured& measured, const std::string& engine);

/// "For an error below 1 cm, 1 mm, 0.1 mm, 1 µm the cheapest setting is ..., and costs ... us a frame of 1/60 s; its error is ..., of
/// which ... remains as h -> 0."
std::string table_of_cheapest(const std::vector<MotionMeasured>& all);

/// A row a motion. What `Recommended` with an error of 1 mm takes for a frame, and how far off it is; a column a maker with all of his
/// engines: the cheapest setting below 1 mm and its time for a frame; or the least error that it reaches.
std::string table_of_engines(const std::vector<MotionMeasured>& all, const std::vector<Engine>& engines);

/// For the same four errors: how many times as long the others take as we do.
std::string table_of_others(const std::vector<MotionMeasured>& all, const std::vector<Engine>& engines);

/// How many motions ours plays faster than all other engines, for six errors, with all of our settings and with some; and by which factor
/// the next engine is slower, in the median: for all motions, for those that are piecewise quadratic or rest, for the others.
std::string table_of_regimes(const std::vector<MotionMeasured>& all);
/// A row a motion: the fastest other engine for each of the six errors, and the ratio of its time to ours.
std::string table_of_next(const std::vector<MotionMeasured>& all);
/// Our least time for 1 cm, 1 mm and 0.1 mm without the methods of chapters 24 to 27, and with them.
std::string table_of_half_steps(const std::vector<MotionMeasured>& all);
/// Our least time with contacts detected in each substep, and detected once in 1/60 s.
std::string table_of_once(const std::vector<MotionMeasured>& all);

/// Settings whose robust error is above an error that their own is below, and the cheapest whose robust error is below it, where it takes
/// twice as long.
std::string table_of_choices(const std::vector<MotionMeasured>& all);

/// A row a knob and motion: by what a doubling changes error and time, from slopes; warm against cold, float against double.
std::string table_of_knobs(const std::vector<MotionMeasured>& all);
/// Error against the two knobs that are numbers, in the rows of table_of_knobs.
std::vector<Panel> panels_of_knobs(const std::vector<MotionMeasured>& all);

/// What remains of every method's error as h -> 0, and of which order in h is what smaller steps remove; see limits.h.
/// Tables of motions that are alike: bodies move, bodies rest, bodies hang ...
std::string table_of_limits(const std::vector<MotionMeasured>& all);

/// The speed, height and error that a body lifts off with by the relaxed law, and what remains of MuJoCo's error.
std::string table_of_hops(const std::vector<MotionMeasured>& all);

// What docs/methods.md shows: methods of the literature, and ours beside them.

/// Ours first.
const std::vector<std::string>& compared_methods();
/// Error against time, the front of each of them in its own colour, from what all engines have measured of one motion.
Panel fronts_of_compared(const MotionMeasured& measured);
/// Errors, mm, a row a method and a column a motion, in so many substeps and sweeps; of methods without sweeps in so many substeps.
std::string table_of_errors(const std::vector<MotionMeasured>& all, int substeps, int sweeps);
/// The least time for 1/60 s with a robust error of at most `error`, m, and its setting, likewise.
std::string table_of_times(const std::vector<MotionMeasured>& all, double error);

/// Where, of what and under what load was measured: without these a time says nothing.
struct MachineReport {
  std::string load_before, load_after;
  std::chrono::duration<double> took;
  std::vector<std::string> versions;  ///< of the engines, in their order
  int resumed = 0;                    ///< motions that were measured before, by a run that was ended
};
/// The machine and the engines, and how many settings of each were tried.
std::string table_of_machine(const MachineReport& run, const std::vector<Engine>& engines, const AllMeasured& all);

}  // namespace pushback::study
