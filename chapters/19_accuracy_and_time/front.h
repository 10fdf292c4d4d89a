/// Measurements, and the settings worth choosing, so that no other setting is both faster and more accurate.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace pushback::study {

/// One motion played in one setting, with all its timings.
struct Measured {
  std::string engine;                     ///< "motion" or "motion_bullet": the program that played it
  std::string method;                     ///< "steady"
  int substeps = 1;                       ///< in a frame of 1/60 s
  int sweeps = 0;                         ///< in a substep; 0: the method has no such setting
  double error = 0;                       ///< m; infinite: lost or given up
  bool late = false;                      ///< given up before its end
  std::optional<double> row_solves = {};  ///< in the whole motion; nothing: not measured
  std::vector<double> seconds = {};       ///< for the whole motion, one per round, ascending

  double median() const;
  double quartile(int which) const;  ///< `which`: 1 or 3. For a single timing, a fifth less or more than it
  std::string setting() const;       ///< "steady/32/1"
};
using Measurements = std::vector<Measured>;

/// Whether `one` is the same method of the same engine, with as many substeps or more, and as many sweeps or more. Each is as fine
/// as itself.
bool is_as_fine(const Measured& one, const Measured& than);

/// The same measurements in the same order, each with the largest error of all settings that are as fine. If two errors cancel by
/// chance in one setting, finer settings show the larger error, so a front of these does not depend on such chances. The error of a
/// lost motion counts for coarser settings, too. The error of one that was given up counts only for itself.
Measurements robust(const Measurements& all);

/// The measurements for which no other is faster without more error, by ascending time and descending error.
Measurements front(Measurements all);

/// Whether `one`, a member of `all`, takes at most `slack` times as long as the fastest without more error.
bool is_near_front(const Measured& one, const Measurements& all, double slack);

/// The fastest with at most this error (m), or nothing if there is none.
std::optional<Measured> cheapest(const Measurements& all, double error);

/// Which of two settings is the faster: 1 the first, -1 the second. 0: neither, because their times overlap between their quartiles, or
/// their medians differ by less than a tenth.
int faster(const Measured& one, const Measured& other);

/// The same for the cheapest settings with errors of 0.8, 1 and 1.25 times `error`, or 0 unless all three agree. So no single setting
/// with an error close to the bound decides. A list that does not reach such an error is the slower one.
int faster(const Measurements& ones, const Measurements& others, double error);

/// The slope of the straight line through (log x, log y), by least squares. All values are above 0, with two or more
/// different x.
double slope(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace pushback::study
