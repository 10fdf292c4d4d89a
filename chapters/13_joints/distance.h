/// A massless rod, which keeps two points at a fixed distance.
#pragma once

#include "pushback/common/basics/input.h"
#include "pushback/common/world/joint.h"
#include "pushback/common/world/world.h"

namespace pushback {

/// A rod from P_A to P_B (m, world axes, for the current poses).
///
///   C = |P_B - P_A| - L,   C' = n . (v_B + w_B x r_B - v_A - w_A x r_A),   n = (P_B - P_A) / |P_B - P_A|
///
/// The row of a contact, except that it also pulls. `length`: L, m; 0: the current distance.
inline Joint distance(const World& world, int a, const Vec3& point_a, int b, const Vec3& point_b, Real length = 0) {
  check_joined(world, "a distance", a, b);
  require_finite("anchor of a distance", point_a);
  require_finite("anchor of a distance", point_b);
  if (length == 0) length = (point_b - point_a).norm();
  require_positive("length of a distance", length);
  const Vec3 on_a = point_on(body_of(world, a), point_a), on_b = point_on(body_of(world, b), point_b);

  const auto ask = [=](const Body& first, const Body& second, const TimeStep&, Equations& equations) {
    const Vec3 p_a = point_of(first, on_a), p_b = point_of(second, on_b);
    const Real apart = (p_b - p_a).norm();
    const Vec3 n = apart > 0 ? Vec3((p_b - p_a) / apart) : Vec3::UnitY();  // coincident, so any direction is correct
    equations.push_back({.jacobian = Jacobian::along(n, first, p_a, second, p_b), .error = apart - length});
  };
  const auto line = [=](const Body& first, const Body& second) {
    return std::vector<Vec3>{point_of(first, on_a), point_of(second, on_b)};
  };
  return {"a distance", a, b, ask, line};
}

}  // namespace pushback
