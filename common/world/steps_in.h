/// Times in steps.
#pragma once

#include <algorithm>
#include <cmath>

#include "pushback/common/basics/types.h"

namespace pushback {

/// How many steps of dt make up so many seconds: at least one.
inline int steps_in(Real seconds, Real dt) {
  return std::max(1, static_cast<int>(std::lround(seconds / dt)));
}

}  // namespace pushback
