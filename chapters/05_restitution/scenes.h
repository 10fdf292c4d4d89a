/// What bounces: balls of different e, boxes that hardly move, five balls in a row.
#pragma once

#include <fmt/format.h>

#include "pushback/common/experiment/experiment.h"

namespace pushback {

inline constexpr Real ball_radius = Real(0.3), drop = 2;  // m
inline const std::vector<Real> bounciness{0, Real(0.5), Real(0.8), 1};

inline void four_balls(World& world) {
  world.add(ground().bouncy(0));
  for (std::size_t i = 0; i < bounciness.size(); ++i) {
    const Real x = (static_cast<Real>(i) - Real(1.5)) * Real(1.1);
    world.add(sphere(ball_radius, 10).at({x, ball_radius + drop, 0}).bouncy(bounciness[i]));
    // A shelf behind each, as high as the ball should come.
    const Real apex = bounciness[i] * bounciness[i] * drop;
    if (apex > 0) world.add(box({Real(0.5), Real(0.02), Real(0.1)}, 1).fixed().at({x, apex - Real(0.02), Real(-0.42)}));
  }
}

/// Of the ball with that e, m above where it lies on the ground. (Before it stand the ground, and two bodies for each ball but
/// the first, which has no shelf.)
inline Real height_of(const World& world, std::size_t ball) {
  return world.bodies[ball == 0 ? 1 : 2 * ball].position.y() - ball_radius;
}

/// Highest point after the bounce number `bounce`, from 0, of the ball with index `ball`, m above the ground it rests on.
inline std::function<Real(const Run&)> apex(std::size_t ball, std::size_t bounce = 0) {
  return [ball, bounce](const Run& run) {
    const auto& heights = run.series.at(fmt::format("height, e = {}", bounciness[ball]));
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

/// The first of five equal balls runs into the other four, which rest `gap` m from each other.
inline std::function<void(World&)> five_in_a_row(Real gap) {
  return [gap](World& world) {
    world.gravity.setZero();
    for (int i = 0; i < 5; ++i) {
      const Real x = i == 0 ? Real(-2.4) : static_cast<Real>(i - 1) * (2 * ball_radius + gap);
      world.add(sphere(ball_radius, 10).at({x, ball_radius, 0}).moving({i == 0 ? Real(4) : 0, 0, 0}).bouncy(1));
    }
  };
}

}  // namespace pushback
