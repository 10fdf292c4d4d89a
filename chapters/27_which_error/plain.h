/// A bar that bounces, and two estimates of its error: a sum over steps, each taken twice from the same state, and a twin.
#pragma once

#include <cmath>

#include "pushback/common/world/world.h"

namespace pushback::plain_27 {

/// A thin bar of 1 m and 1 kg in a plane, above a smooth floor at y = 0. It bounces with e = 1.
struct Bar {
  Real y, v;         // of its centre, m, m/s, upwards
  Real angle, spin;  // to the floor, rad, rad/s
};
constexpr Real half_length = Real(0.5), inertia = Real(1) / 12;  // m and kg m^2

inline Bar moved(const Bar& bar, Real t) {
  return {bar.y + t * bar.v, bar.v, bar.angle + t * bar.spin, bar.spin};
}

/// The height of its lower end, m.
inline Real gap(const Bar& bar) {
  return bar.y - half_length * std::abs(std::sin(bar.angle));
}

/// The distance of its lower end to the right of its centre, m.
inline Real lower_arm(const Bar& bar) {
  return (std::sin(bar.angle) > 0 ? -half_length : half_length) * std::cos(bar.angle);
}

/// The impulse of chapter 5 at this arm, if that end approaches the floor.
inline void bounce(Bar& bar, Real arm) {
  const Real approach = bar.v + arm * bar.spin;
  if (approach >= 0) return;
  const Real impulse = -2 * approach / (1 + arm * arm / inertia);
  bar.v += impulse;
  bar.spin += arm * impulse / inertia;
}

constexpr int most_impacts = 20;  // in a substep

/// A substep of h seconds, of order 1: gravity acts at its start. It is cut at each impact, as in chapter 25.
inline void substep(Bar& bar, Real h) {
  bar.v -= World::g * h;
  for (int impacts = 0; impacts < most_impacts && gap(moved(bar, h)) < 0; ++impacts) {
    Real above = 0, below = h;
    for (int i = 0; i < 50; ++i) {
      const Real middle = (above + below) / 2;
      (gap(moved(bar, middle)) < 0 ? below : above) = middle;
    }
    const Real arm = lower_arm(moved(bar, below));
    bar = moved(bar, above);
    bounce(bar, arm);
    h -= above;
  }
  bar = moved(bar, h);
}

inline Bar step(Bar bar, Real h, int substeps) {
  for (int i = 0; i < substeps; ++i) substep(bar, h / static_cast<Real>(substeps));
  return bar;
}

/// A bar, and two estimates of its error.
struct Played {
  Bar bar, twin;    // `twin` begins equal to `bar`
  Real halves = 0;  // m, the sum over all steps

  Real said_by_twin() const { return std::abs(bar.y - twin.y) / 2; }
};

constexpr int fine = 64, coarse = 17;  // substeps in a step of the bar and of its twin

inline void play_step(Played& played, Real h) {
  const Bar half = step(played.bar, h, fine / 2);
  played.bar = step(played.bar, h, fine);
  // An error of the velocity lasts for half a second on average, if errors are allowed for one second.
  played.halves += std::abs(played.bar.y - half.y) + std::abs(played.bar.v - half.v) / 2;
  played.twin = step(played.twin, h, coarse);
}

}  // namespace pushback::plain_27
