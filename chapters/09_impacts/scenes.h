/// Five balls in a row. The scene of three bounces is chapter 05's FallingBalls.
#pragma once

#include "pushback/chapters/05_restitution/scenes.h"
#include "pushback/common/render/palette.h"

namespace pushback::impacts_scenes {

using restitution_scenes::ball_radius;

inline constexpr Real arriving_speed = 4;  // m/s

/// The first of five equal balls runs into the other four, which rest `gap` m from each other.
inline std::function<void(World&)> five_in_a_row(Real gap) {
  return [gap](World& world) {
    world.gravity.setZero();
    for (int i = 0; i < 5; ++i) {
      const Real x = i == 0 ? Real(-2.4) : static_cast<Real>(i - 1) * (2 * ball_radius + gap);
      world.add(sphere(ball_radius, 10).at({x, ball_radius, 0}).moving({i == 0 ? arriving_speed : 0, 0, 0}).bouncy(1));
    }
  };
}

/// An arrow in front of each ball, 0.25 m for 1 m/s.
inline void add_speeds(Picture& picture, const World& world) {
  constexpr Real thickness = Real(0.07);  // m
  const Vec3 towards_us = (picture.camera.eye - picture.camera.target).normalized();
  for (const Body& ball : world.bodies) {
    const Vec3 before = ball.position + Real(1.2) * ball_radius * towards_us;
    if (ball.velocity.norm() > Real(0.1))
      picture.arrows.push_back({before, before + ball.velocity / 4, thickness, near_black_colour()});
  }
}

}  // namespace pushback::impacts_scenes
