/// Bouncing balls of different e, and boxes that hardly move.
#pragma once

#include <fmt/format.h>

#include "pushback/common/experiment/experiment.h"

namespace pushback::restitution_scenes {

inline constexpr Real ball_radius = Real(0.3);  // m

struct FallingBalls {
  std::vector<Real> bounciness{0, Real(0.5), Real(0.8), 1};  ///< e of each ball
  Real drop = 2;                                             ///< m

  void operator()(World& world) const {
    world.add(ground().bouncy(0));
    for (std::size_t i = 0; i < bounciness.size(); ++i) {
      const Real x = (static_cast<Real>(i) - static_cast<Real>(bounciness.size() - 1) / 2) * Real(1.1);
      world.add(sphere(ball_radius, 10).at({x, ball_radius + drop, 0}).bouncy(bounciness[i]));
      if (bounciness[i] > 0) {  // a shelf behind each ball, at the height that the ball should reach
        const Vec3 shelf(x, apex(bounciness[i], 1) - Real(0.02), Real(-0.42));
        world.add(box({Real(0.5), Real(0.02), Real(0.1)}, 1).fixed().at(shelf));
      }
    }
  }

  /// The height after bounce number k, from 1, m. It is e^2k of the drop, or 0 if the ball arrives more slowly than `threshold`, m/s.
  Real apex(Real e, int k, Real threshold = 0) const {
    const Real arrives = std::sqrt(2 * World::g * drop) * std::pow(e, static_cast<Real>(k - 1));
    return arrives > threshold ? drop * std::pow(e, static_cast<Real>(2 * k)) : 0;
  }
  /// The height of the ball with that index above its position at rest on the ground, m.
  Real height_of(const World& world, std::size_t ball) const {
    const auto shelves = std::count_if(bounciness.begin(), bounciness.begin() + static_cast<std::ptrdiff_t>(ball),
                                       [](Real e) { return e > 0; });
    return world.bodies[1 + ball + static_cast<std::size_t>(shelves)].position.y() - ball_radius;
  }
};

/// A single ball, small enough for pictures at many instants side by side.
struct BouncingBall {
  Real e = Real(0.8), drop = 2, radius = Real(0.13);  ///< drop and radius in m

  void operator()(World& world) const {
    world.add(ground().bouncy(0));
    world.add(sphere(radius, 10).at({0, radius + drop, 0}).bouncy(e));
  }
  /// The time of bounce number k, from 1, s. For k = 0, minus the time of the first bounce.
  Real lands(int k) const {
    Real sum = -1;
    for (int i = 0; i < k; ++i) sum += 2 * std::pow(e, static_cast<Real>(i));
    return std::sqrt(2 * drop / World::g) * sum;
  }
  /// The height after bounce number k, from 1, m, which is e^2k of the drop.
  Real apex(int k) const { return drop * std::pow(e, static_cast<Real>(2 * k)); }
};

/// The highest point after bounce number `bounce`, from 0, in a series of heights, m.
inline std::function<Real(const Run&)> apex(const std::string& series, std::size_t bounce = 0) {
  return [series, bounce](const Run& run) {
    const auto& heights = run.series.at(series);
    std::size_t i = 1;
    const auto down = [&] {
      while (i + 1 < heights.size() && heights[i] <= heights[i - 1]) ++i;
    };
    const auto up = [&] {
      while (i + 1 < heights.size() && heights[i] >= heights[i - 1]) ++i;
    };
    down();
    for (std::size_t k = 0; k < bounce; ++k) {
      up();
      down();
    }
    up();
    return heights[i - 1];
  };
}

inline void at_rest(World& world) {
  world.add(ground());
  for (int i = 0; i < 3; ++i)
    world.add(box({Real(0.4), Real(0.4), Real(0.4)}, 100)
                  .at({(static_cast<Real>(i) - 1) * Real(1.2), Real(0.42), 0})
                  .bouncy(Real(0.8)));
}

}  // namespace pushback::restitution_scenes
