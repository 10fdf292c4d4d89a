/// Exercise 13: a hinge. The task is chapters/13_joints/exercise/task.md.
#pragma once

#include "pushback/chapters/13_joints/exercise/asked.h"

namespace student {

using namespace pushback;

/// A point and an axis in common. `anchor`: m; `axis`: unit; both in world axes, as the bodies stand when the hinge is made.
inline Joint hinge(const World& world, int a, int b, const Vec3& anchor, const Vec3& axis) {
  const Body &made_a = body_of(world, a), &made_b = body_of(world, b);
  const Vec3 on_a = point_on(made_a, anchor), on_b = point_on(made_b, anchor);
  const Tangents across = tangents_of(axis);
  const Vec3 s1 = made_a.orientation.conjugate() * across.tangent1,
             s2 = made_a.orientation.conjugate() * across.tangent2;
  const Vec3 u = made_b.orientation.conjugate() * axis;

  // Called in every step, with the bodies as they stand then. You read
  //   on_a, on_b   the point as each body carries it, m:  point_of(first, on_a) is P_A, point_of(second, on_b) is P_B
  //   s1, s2       two directions across the axis, in A's axes: first.orientation * s1 is where s1 points now
  //   u            the axis, in B's axes
  // and append, for each of the five rows, J = [-n  -ra_n  n  rb_n] and C, m or rad:
  //   equations.push_back({.jacobian = {.ra_n = ..., .n = ..., .rb_n = ...}, .error = ...});
  const auto ask = [=](const Body& first, const Body& second, const TimeStep&, Equations& equations) {
    // TODO three rows that keep P_A and P_B together; two that keep s1 and s2 perpendicular to u (the table of the page)
    (void)first, (void)second, (void)equations;           // take this line out,
    (void)on_a, (void)on_b, (void)s1, (void)s2, (void)u;  // and this one
    // TODO ends
  };
  return {"your hinge", a, b, ask};
}

inline const exercise_13::Answer answer{hinge};

}  // namespace student
