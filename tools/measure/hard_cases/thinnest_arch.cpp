#include "pushback/tools/measure/hard_cases/thinnest_arch.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pushback {

namespace {

/// How much wider than needed the joints are for the line of thrust of a level thrust H; below 0: no line fits.
///
/// By symmetry the crown's force is level, at a height y0. The part of the arch from the crown to a joint at the angle a has the
/// weight W = a (ro^2 - ri^2) / 2, its moment about the middle M = (1 - cos a) (ro^3 - ri^3) / 3, with a unit weight of an area. The
/// joint's force goes through it at the radius r:
///
///   H (y0 - r cos a) = W r sin a - M    =>    r f = H y0 + M,    f = W sin a + H cos a
///
/// ri <= r <= ro at each joint bounds H y0 from both sides.
Real room(int voussoirs, Real inner, Real outer, Real thrust) {
  Real low = -std::numeric_limits<Real>::infinity(), high = -low;  // of H y0
  for (int i = 0; 2 * i <= voussoirs; ++i) {
    const Real a = pi / 2 - pi / static_cast<Real>(voussoirs) * static_cast<Real>(i);
    const Real weight = a * (outer * outer - inner * inner) / 2;
    const Real moment = (1 - std::cos(a)) * (outer * outer * outer - inner * inner * inner) / 3;
    const Real f = weight * std::sin(a) + thrust * std::cos(a);
    low = std::max(low, inner * f - moment);
    high = std::min(high, outer * f - moment);
  }
  return high - low;
}

/// The H with the most room. The room is the least of functions linear in H, so it is concave: the better third is kept.
Real best_thrust(int voussoirs, Real inner, Real outer) {
  Real low = 0, high = 2 * (outer * outer - inner * inner);  // more than the weight of the half, pi / 4 of this
  for (int i = 0; i < 200; ++i) {
    const Real third = (high - low) / 3, p = low + third, q = high - third;
    (room(voussoirs, inner, outer, p) < room(voussoirs, inner, outer, q) ? low : high) =
        room(voussoirs, inner, outer, p) < room(voussoirs, inner, outer, q) ? p : q;
  }
  return (low + high) / 2;
}

}  // namespace

ThinnestArch thinnest_arch(int voussoirs) {
  Real thin = 0, thick = 1;  // too thin, thick enough
  for (int i = 0; i < 50; ++i) {
    const Real t = (thin + thick) / 2, inner = 1 - t / 2, outer = 1 + t / 2;
    (room(voussoirs, inner, outer, best_thrust(voussoirs, inner, outer)) < 0 ? thin : thick) = t;
  }
  const Real inner = 1 - thick / 2, outer = 1 + thick / 2;
  const Real half = pi / 4 * (outer * outer - inner * inner);
  return {thick, best_thrust(voussoirs, inner, outer) / half};
}

}  // namespace pushback
