/// What was measured, as diagrams and as tables.
#pragma once

#include <map>

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

/// Markdown. "For an error below 1 cm, 1 mm, 0.1 mm, 1 µm the cheapest setting is ..., and costs ... us a frame of 1/60 s;
/// its error is ..., of which ... remains as h -> 0."
std::string table_of_cheapest(const std::vector<MotionMeasured>& all);

/// Markdown. A row a motion. What the solver that is told 1 mm takes for a frame, and how far off it is; a column an engine with all of
/// its builds: the cheapest setting below 1 mm and its time for a frame; or
/// the least error that it reaches.
std::string table_of_engines(const std::vector<MotionMeasured>& all);

/// Markdown. For the same four errors: how many times as long the others take as we do; what remains of their error and of ours
/// as h -> 0, in the same steps, each by the method of which the least does.
std::string table_of_others(const std::vector<MotionMeasured>& all, const std::vector<Engine>& engines);

/// Markdown. A row a knob and motion: by what a doubling changes error and time, from slopes; warm against cold, float against
/// double.
std::string table_of_knobs(const std::vector<MotionMeasured>& all);

/// Markdown. What remains of every method's error as h -> 0, and of which order in h is what smaller steps remove; see limits.h.
/// In three tables: bodies move, bodies rest, bodies hang.
std::string table_of_limits(const std::vector<MotionMeasured>& all);

/// Markdown. The speed, height and error that a body lifts off with by the relaxed law, and what remains of MuJoCo's error.
std::string table_of_hops(const std::vector<MotionMeasured>& all);

/// Error against the two knobs that are numbers, in the rows of table_of_knobs.
std::vector<Panel> panels_of_knobs(const std::vector<MotionMeasured>& all);

}  // namespace pushback::study
