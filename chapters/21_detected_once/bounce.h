/// How a body bounces within one substep.
#pragma once

#include <algorithm>
#include <cmath>

#include "pushback/common/basics/types.h"

namespace pushback {

/// What comes at u from C above the surface, and is pressed on by a, touches it within this substep. By steps of
/// v += h a, x += h v  flight keeps  S = u^2 / 2 + a C + h a u / 2, half the square of the speed at the surface (chapter 09). So
///
///   C' = e (h U - C),   U = sqrt(2 S)                the rest of the way of the substep, back, at e times the speed
///   v^2 / 2 + a C' - h a v / 2 = e^2 S
///
/// With C' = e U h from where it is, if it is already inside.
struct Bounce {
  Real way;    ///< C' - C, m: what the substep is to move
  Real speed;  ///< v, m/s: with what the next one begins

  /// `gained`: h a, m/s; at least 0 counts.
  Bounce(Real e, Real C, Real u, Real gained, Real h) {
    const Real ha = std::max(Real(0), gained), aC = ha * C / h;
    const Real s = std::max(Real(0), u * u / 2 + aC + ha * u / 2), at_surface = std::sqrt(2 * s);
    way = C > 0 ? e * (h * at_surface - C) - C : e * h * at_surface;
    speed = ha / 2 + std::sqrt(std::max(Real(0), ha * ha / 4 + 2 * (e * e * s - aC - ha * way / h)));
  }
};

}  // namespace pushback
