/// Predicts the computing time and the error of a scene before it is played.
#pragma once

#include <string>

#include "pushback/common/world/world.h"

namespace pushback {

struct Prediction {
  double seconds = 0;    ///< computing time of all steps
  Real error = 0;        ///< m, the largest in any step
  std::string no_time;   ///< why the time is not predictable; empty: it is
  std::string no_error;  ///< why the error is not predictable; empty: it is
  double rehearsed = 0;  ///< s, the computing time of the rehearsals
};

/// The prediction for `steps` steps of 1/60 s within `error`, m. The whole scene is rehearsed in steps four times as long, and in steps
/// twice as long.
Prediction predict(const World& begin, Real error, int steps);

}  // namespace pushback
