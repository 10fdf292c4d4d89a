/// Converts times to numbers of steps.
#pragma once

#include <algorithm>
#include <cmath>

#include "pushback/common/basics/types.h"

namespace pushback {

/// The number of steps of dt (s) in `seconds`, rounded, at least 1.
inline int steps_in(Real seconds, Real dt) {
  return std::max(1, static_cast<int>(std::lround(seconds / dt)));
}

}  // namespace pushback
