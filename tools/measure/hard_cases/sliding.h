/// A flat box of 20 kg that slides, and how far friction lets it.
#pragma once

#include <cmath>

#include "pushback/common/world/situations.h"

namespace pushback {

/// On a slope, 0.01 mm deep: all four corners touch from the start.
inline void box_on_slope(World& world, Real theta, Real mu) {
  const Vec3 up{-std::sin(theta), std::cos(theta), 0};
  world.add(half_space(up).rough(mu));
  world.add(box({Real(0.2), Real(0.05), Real(0.2)}, 20).turned(theta, Vec3::UnitZ()).at(Real(0.04999) * up).rough(mu));
}

/// The same on the level, sent off under `heading`, its sides along its way.
inline void sliding_box(World& world, Real mu, Real speed, Real heading) {
  world.add(ground().rough(mu));
  world.add(box({Real(0.2), Real(0.05), Real(0.2)}, 20)
                .turned(heading, Vec3::UnitY())
                .at({0, Real(0.04999), 0})
                .moving(speed * Vec3(std::cos(heading), 0, -std::sin(heading)))
                .rough(mu));
}

/// The sum of dt (v0 - k mu g dt) as far as that is positive: what v0^2 / (2 mu g) is in steps of dt.
inline Real discrete_distance(Real mu, Real speed, Real dt) {
  if (dt == 0) return speed * speed / (2 * mu * World::g);
  Real way = 0;
  for (Real v = speed - mu * World::g * dt; v > 0; v -= mu * World::g * dt) way += dt * v;
  return way;
}

}  // namespace pushback
