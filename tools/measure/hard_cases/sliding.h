/// A flat box of 20 kg that slides, and the distance that friction allows.
#pragma once

#include <cmath>

#include "pushback/common/world/situations.h"

namespace pushback {

/// The box on a slope, 0.01 mm deep, so that all four corners touch from the start.
inline void box_on_slope(World& world, Real theta, Real mu) {
  const Vec3 up{-std::sin(theta), std::cos(theta), 0};
  world.add(half_space(up).rough(mu));
  world.add(box({Real(0.2), Real(0.05), Real(0.2)}, 20).turned(theta, Vec3::UnitZ()).at(Real(0.04999) * up).rough(mu));
}

/// The same box on level ground. It starts in the direction `heading` (rad), with its sides parallel to its path.
inline void sliding_box(World& world, Real mu, Real speed, Real heading) {
  world.add(ground().rough(mu));
  world.add(box({Real(0.2), Real(0.05), Real(0.2)}, 20)
                .turned(heading, Vec3::UnitY())
                .at({0, Real(0.04999), 0})
                .moving(speed * Vec3(std::cos(heading), 0, -std::sin(heading)))
                .rough(mu));
}

/// The sum of dt (v0 - k mu g dt) over all positive terms, the discrete form of v0^2 / (2 mu g) in steps of dt, m.
inline Real discrete_distance(Real mu, Real speed, Real dt) {
  if (dt == 0) return speed * speed / (2 * mu * World::g);
  Real way = 0;
  for (Real v = speed - mu * World::g * dt; v > 0; v -= mu * World::g * dt) way += dt * v;
  return way;
}

}  // namespace pushback
