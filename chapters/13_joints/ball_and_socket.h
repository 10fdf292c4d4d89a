/// A ball and socket: three rows, which leave three rotations.
#pragma once

#include "pushback/common/basics/input.h"
#include "pushback/common/world/joint.h"
#include "pushback/common/world/world.h"

namespace pushback {

/// C = P_B - P_A, along the three world axes. P_A is fixed in A and P_B in B; both are at `anchor` (m, world axes) now.
struct Anchor {
  Vec3 on_a, on_b;  ///< m, body axes

  Anchor(const World& world, int a, int b, const Vec3& anchor)
      : on_a(point_on(body_of(world, a), anchor)), on_b(point_on(body_of(world, b), anchor)) {}

  void ask(const Body& a, const Body& b, Equations& equations) const {
    const Vec3 p_a = point_of(a, on_a), p_b = point_of(b, on_b);
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3 n = Vec3::Unit(axis);
      equations.push_back({.jacobian = Jacobian::along(n, a, p_a, b, p_b), .error = p_b[axis] - p_a[axis]});
    }
  }
};

/// `anchor`: m, world axes, for the current poses.
inline Joint ball_and_socket(const World& world, int a, int b, const Vec3& anchor) {
  check_joined(world, "a ball and socket", a, b);
  require_finite("anchor of a ball and socket", anchor);
  const Anchor there(world, a, b, anchor);
  const auto ask = [there](const Body& first, const Body& second, const TimeStep&, Equations& equations) {
    there.ask(first, second, equations);
  };
  return {"a ball and socket", a, b, ask};
}

}  // namespace pushback
