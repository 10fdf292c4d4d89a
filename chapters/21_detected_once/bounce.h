/// The bounce of a body within one substep.
#pragma once

#include <algorithm>
#include <cmath>

#include "pushback/common/basics/types.h"

namespace pushback {

/// A body at C above the surface approaches at u, accelerated towards it by a, and touches it within this substep. In flight, steps
/// of  v += h a, x += h v  conserve  S = u^2 / 2 + a C + h a u / 2, half the square of the speed at the surface (chapter 09). So
///
///   C' = e (h U - C),   U = sqrt(2 S)                the remaining distance of the substep, back, at e times the speed
///   v^2 / 2 + a C' - h a v / 2 = e^2 S
///
/// A body that is already inside moves by e U h from its position.
struct Bounce {
  Real way;    ///< C' - C, m: the displacement in this substep
  Real speed;  ///< v, m/s: the speed at the start of the next one

  /// `gained`: h a, m/s. A negative value counts as 0.
  Bounce(Real e, Real C, Real u, Real gained, Real h) {
    const Real ha = std::max(Real(0), gained), aC = ha * C / h;
    const Real s = std::max(Real(0), u * u / 2 + aC + ha * u / 2), at_surface = std::sqrt(2 * s);
    way = C > 0 ? e * (h * at_surface - C) - C : e * h * at_surface;
    speed = ha / 2 + std::sqrt(std::max(Real(0), ha * ha / 4 + 2 * (e * e * s - aC - ha * way / h)));
  }
};

}  // namespace pushback
