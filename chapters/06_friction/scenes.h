/// Scenes with friction and their theory, with three boxes on a slope, boxes pushed off in several directions, and a thrown ball.
#pragma once

#include <array>

#include "pushback/common/world/situations.h"

namespace pushback::friction_scenes {

/// The distance from the origin at which boxes start, m, so large that boxes in different directions do not touch.
inline constexpr Real start = Real(1.2);

/// The coefficient that gives the geometric mean `wanted` against a ground with mu = 1.
inline Real own_friction(Real wanted) {
  return wanted * wanted;
}

/// The colours of three boxes side by side: mustard, brick and olive, which no curve or marker uses.
inline constexpr std::array<int, 3> colours{2, 4, 5};

/// Three boxes on one slope, with mu below, just above, and far above tan(theta).
inline const std::array<Real, 3> grip{Real(0.8), Real(1.05), Real(1.5)};
struct BoxesOnSlope {
  Real theta = Real(0.7);  ///< rad

  void operator()(World& world) const {
    incline(world, theta, 1);
    const Vec3 up{-std::sin(theta), std::cos(theta), 0};
    const Vec3 along{std::cos(theta), std::sin(theta), 0};
    for (std::size_t i = 0; i < grip.size(); ++i) {
      const Vec3 begin = Real(4.2) * along + Real(0.29999) * up + Vec3(0, 0, (static_cast<Real>(i) - 1) * Real(1.2));
      world.add(box({Real(0.4), Real(0.3), Real(0.4)}, 50)
                    .turned(theta, Vec3::UnitZ())
                    .at(begin)
                    .coloured(colours[i])
                    .rough(own_friction(grip[i] * std::tan(theta))));
    }
  }
  /// The distance that the box with that index has slid down the slope, m.
  Real slid(const World& world, std::size_t body) const {
    const Vec3 along{std::cos(theta), std::sin(theta), 0};
    return Real(4.2) - world.bodies[body].position.dot(along);
  }
  /// The acceleration of a sliding box down the slope, m/s^2.
  Real acceleration(Real of_grip) const {
    return World::g * (std::sin(theta) - of_grip * std::tan(theta) * std::cos(theta));
  }
};
/// The distance covered by a body that starts at rest and whose speed grows by a h in each of n steps, m.
inline Real way_of(Real a, Real h, Real n) {
  return a * h * h * n * (n + 1) / 2;
}

/// The initial speed and the friction of bodies that slide over level ground.
struct Push {
  Real v0 = 5;          ///< m/s
  Real mu = Real(0.5);  ///< between a body and the ground

  /// The stopping distance, m. It is the sum of h (v0 - k mu g h) over all positive terms, the discrete form of v0^2 / (2 mu g).
  Real stopping_distance(Real h) const {
    Real way = 0;
    for (Real v = v0 - mu * World::g * h; v > 0; v -= mu * World::g * h) way += h * v;
    return way;
  }
  /// 1.1 times the time in which a body stops, but at least `least`, s.
  Real long_enough(Real least) const { return std::max(least, Real(1.1) * v0 / (mu * World::g)); }
};

inline void slide(World& world, const std::vector<Real>& headings, const Push& push = {}) {
  world.add(ground().rough(1));
  for (std::size_t i = 0; i < headings.size(); ++i) {
    const Vec3 way{std::cos(headings[i]), 0, -std::sin(headings[i])};
    world.add(box({Real(0.2), Real(0.1), Real(0.2)}, 20)
                  .turned(headings[i], Vec3::UnitY())
                  .at(way * start + Vec3(0, Real(0.09999), 0))
                  .moving(push.v0 * way)
                  .coloured(colours[i % colours.size()])
                  .rough(own_friction(push.mu)));
  }
}
/// The same with a post just beyond where each box should stop.
inline void slide_to_posts(World& world, const std::vector<Real>& headings, Real h, const Push& push = {}) {
  slide(world, headings, push);
  for (const Real heading : headings) {
    const Vec3 way{std::cos(heading), 0, -std::sin(heading)};
    world.add(box({Real(0.05), Real(0.25), Real(0.25)}, 1)
                  .fixed()
                  .turned(heading, Vec3::UnitY())
                  .at(way * (start + push.stopping_distance(h) + Real(0.26)) + Vec3(0, Real(0.25), 0)));
  }
}
inline const std::vector<Real> three_headings{0, pi / 8, pi / 4};
inline Vec3 start_of(Real heading) {
  return start * Vec3(std::cos(heading), 0, -std::sin(heading));
}

inline void thrown_ball(World& world, const Push& push = {}) {
  world.add(ground().rough(1));
  world.add(sphere(Real(0.3), 10).at({-3, Real(0.299999), 0}).moving({push.v0, 0, 0}).rough(own_friction(push.mu)));
}

}  // namespace pushback::friction_scenes
