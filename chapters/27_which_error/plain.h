/// By how much a step is off, and in how many substeps the next one is taken, as plain functions.
#pragma once

#include "pushback/engine/islands/estimate.h"

namespace pushback::plain_27 {

/// m: by how much a place is off, from the same step in n substeps, `fine`, and in n / 2, `coarse`.
inline Real off_by(Real coarse, Real fine, int order) {
  return std::abs(coarse - fine) / parts_of_difference(order);
}

/// A step has been tried.
struct Tried {
  int substeps;  // this time
  Real off;      // in parts of what is allowed
  Real before;   // the same of the try before, in half as many; infinite: there was none
  int order;
};
struct Bounds {
  int least = 2, most = 16;  // substeps
};
struct Verdict {
  bool stands;   // else it is taken again from where it began
  bool kept;     // its error is within what is allowed
  int substeps;  // of the next try: of the same step, or of the next one
};

inline Verdict judge_try(const Tried& tried, const Bounds& bounds) {
  const Worth now = worth(tried.off, tried.before);
  if (now == Worth::more && 2 * tried.substeps <= bounds.most) return {false, false, 2 * tried.substeps};
  const bool fewer = tried.substeps > bounds.least && fewer_will_do(tried.off, tried.order);
  return {true, now == Worth::kept, fewer ? tried.substeps / 2 : tried.substeps};
}

}  // namespace pushback::plain_27
