/// The error of a step, and the number of substeps of the next one, as plain functions.
#pragma once

#include "pushback/engine/islands/estimate.h"

namespace pushback::plain_27 {

/// The error of a place, m, from the same step in n substeps, `fine`, and in n / 2, `coarse`.
inline Real off_by(Real coarse, Real fine, int order) {
  return std::abs(coarse - fine) / parts_of_difference(order);
}

/// A step that was tried.
struct Tried {
  int substeps;  // of this try
  Real off;      // relative to the allowed error
  Real before;   // the same for the try before, with half as many substeps; infinite: none
  int order;
};
struct Bounds {
  int least = 2, most = 16;  // substeps
};
struct Verdict {
  bool stands;   // else the step is repeated from its start
  bool kept;     // its error is within the allowed error
  int substeps;  // of the next try, for the same step or the next one
};

inline Verdict judge_try(const Tried& tried, const Bounds& bounds) {
  const Worth now = worth(tried.off, tried.before);
  if (now == Worth::more && 2 * tried.substeps <= bounds.most) return {false, false, 2 * tried.substeps};
  const bool fewer = tried.substeps > bounds.least && fewer_will_do(tried.off, tried.order);
  return {true, now == Worth::kept, fewer ? tried.substeps / 2 : tried.substeps};
}

}  // namespace pushback::plain_27
