/// What was measured, and what is worth choosing of it: nothing that is both slower and worse than another.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace pushback::study {

/// A motion played in one setting, as often as it was timed.
struct Measured {
  std::string engine;                     ///< "motion", or "motion_bullet": the program that played
  std::string method;                     ///< "steady"
  int substeps = 1;                       ///< in a frame of 1/60 s
  int sweeps = 0;                         ///< in a substep; 0: the method has no such knob
  double error = 0;                       ///< m; infinite: lost, or given up
  bool late = false;                      ///< given up
  std::optional<double> row_solves = {};  ///< in the whole motion; nothing: no measure
  std::vector<double> seconds = {};       ///< for the whole motion, one a round, ascending

  double median() const;
  double quartile(int which) const;  ///< 1 or 3
  std::string setting() const;       ///< "steady/32/1"
};
using Measurements = std::vector<Measured>;

/// Whether it is the same method of the same engine, and no knob of it is coarser: as many substeps or more, and as many sweeps or
/// more. Each is as fine as itself.
bool is_as_fine(const Measured& one, const Measured& than);

/// The same in the same order, where each counts with the largest error of all that are as fine as it is. Where two errors cancel by
/// chance, finer settings have the larger one, and so a front of these is chosen from what holds. What was lost counts; what was
/// given up is nobody's error but its own.
Measurements robust(const Measurements& all);

/// Those that no other is faster than with no more error: by time ascending, errors descending.
Measurements front(Measurements all);

/// Whether one of `all` takes no longer than `slack` times what the fastest of them with no more error takes.
bool is_near_front(const Measured& one, const Measurements& all, double slack);

/// The fastest with at most this error (m).
std::optional<Measured> cheapest(const Measurements& all, double error);

/// The largest factor by which `ours` takes longer for what a point on the front of `theirs` reaches, over those with errors
/// (m) between `least` and `most`; infinite where ours never gets there; 0 where they have no such point. At most 1: ours lies
/// on or below their front.
double times_slower(const Measurements& ours, const Measurements& theirs, double least, double most);

/// The slope of the straight line through (log x, log y), by least squares. All above 0, two or more different x.
double slope(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace pushback::study
