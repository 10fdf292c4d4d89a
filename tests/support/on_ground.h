/// A body in the ground, by itself, for the closed forms of what one contact does.
#pragma once

#include "pushback/common/world/situations.h"
#include "tests/support/yardstick.h"

namespace pushback {

/// One contact alone needs one sweep. A face on the ground has four, which need a few more to agree.
inline constexpr int one_sweep = 1, enough_sweeps = 200;
/// What may be off, relatively or in m and m/s: the rounding of some hundred steps with as many sweeps. In double it
/// stays below 1e-12; the formulas would have to be wrong in the tenth digit to go unnoticed.
inline constexpr Real tiny = in_double ? Real(1e-9) : Real(2e-4);

/// A ball that is `depth` deep in the ground. Its one contact is a row on its own, K = 1/m: no sweeps to wait for.
inline Body& ball_on_ground(World& world, Real depth, Real mass = 10) {
  world.add(ground());
  world.add(sphere(Real(0.3), mass).at({0, Real(0.3) - depth, 0}));
  return world.bodies[1];
}
inline Real depth_of(const Body& ball) {
  return Real(0.3) - ball.position.y();
}
/// A box likewise: four contacts with the same depth.
inline Body& box_on_ground(World& world, Real depth) {
  world.add(ground());
  world.add(box(Vec3::Constant(Real(0.5)), 100).at({0, Real(0.5) - depth, 0}));
  return world.bodies[1];
}

/// Of any row, m/s.
template <class ContactSolver>
Real largest_error(const ContactSolver& solver) {
  Real largest = 0;
  for (const auto& row : solver.rows()) largest = std::max(largest, row.error());
  return largest;
}

}  // namespace pushback
