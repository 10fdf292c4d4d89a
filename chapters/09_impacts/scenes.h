/// Five balls in a row. The ball that bounces three times is chapter 05's FallingBalls.
#pragma once

#include "pushback/chapters/05_restitution/scenes.h"

namespace pushback::impacts_scenes {

using restitution_scenes::ball_radius;

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

}  // namespace pushback::impacts_scenes
