/// What a solver says of its error in a scene, beside what is true.
#pragma once

#include <string>
#include <vector>

#include "pushback/tools/measure/calibration/truth.h"

namespace pushback::calibration {

struct Played {
  std::uint64_t number;
  std::string kind;
  Real asked, error, said;  ///< m: of the body that is farthest off, and the largest that is said of any
  bool flagged;             ///< `kept` was false once, of one body
  double steps, estimate;   ///< s: of the steps alone, and what the estimate took on top

  /// What must not be: above what was asked, and nothing was said.
  bool missed() const { return !flagged && error > asked; }
  /// At most three times as large as said, or below 0.1 um, which Newton's method leaves.
  bool covered() const { return error <= 3 * std::max(said, Real(1e-7)); }
};

/// By `Recommended`, with the error that is asked and nothing else set; and the same steps again, without a twin.
Played play(const Scene& scene, const Truth& truth);

}  // namespace pushback::calibration
