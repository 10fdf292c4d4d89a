/// A weld: six rows, which leave no relative motion.
#pragma once

#include "pushback/chapters/13_joints/hinge.h"

namespace pushback {

/// The bodies share a point and do not rotate relative to each other. Three perpendicular axes are fixed in both, and each axis of
/// A stays perpendicular to the next axis of B. `anchor`: m, world axes, for the current poses.
inline Joint weld(const World& world, int a, int b, const Vec3& anchor) {
  check_joined(world, "a weld", a, b);
  require_finite("anchor of a weld", anchor);
  const Anchor there(world, a, b, anchor);
  const Quat a_to_b = body_of(world, b).orientation.conjugate() * body_of(world, a).orientation;

  const auto ask = [=](const Body& first, const Body& second, const TimeStep&, Equations& equations) {
    there.ask(first, second, equations);
    const Quat axes_b = second.orientation * a_to_b;
    for (int i = 0; i < 3; ++i) {
      equations.push_back(perpendicular(first.orientation * Vec3::Unit(i), axes_b * Vec3::Unit((i + 1) % 3)));
    }
  };
  return {"a weld", a, b, ask};
}

}  // namespace pushback
