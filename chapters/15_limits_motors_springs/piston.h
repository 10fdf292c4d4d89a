/// A rod whose length is a function of time, which adds a bias to its row.
#pragma once

#include "pushback/common/basics/input.h"
#include "pushback/common/world/joint.h"
#include "pushback/common/world/world.h"

namespace pushback {

/// A rod from P_A to P_B (m, world axes, for the current poses), `length_at(t)` m long. A length of 0 or less throws
/// InvalidInput, also in Joint::ask.
///
///   C = |P_B - P_A| - L(t),   C' = J V + b,   b = -(L(t + h) - L(t)) / h
///
/// J is the same as for a distance (chapter 13). `force`: the largest, N. Catto, GDC 2009, "Modeling Time Dependence".
inline Joint piston(const World& world, int a, const Vec3& point_a, int b, const Vec3& point_b,
                    std::function<Real(Real)> length_at, Real force = std::numeric_limits<Real>::infinity()) {
  const std::string name = "a piston";
  check_joined(world, name, a, b);
  require_finite("anchor of " + name, point_a);
  require_finite("anchor of " + name, point_b);
  if (!length_at) throw InvalidInput(name + " has no length: a function of time is needed");
  require_positive("length of " + name, length_at(world.time));
  if (!(force >= 0)) throw InvalidInput(fmt::format("force of {} is {}: 0 or more is needed", name, force));
  const Vec3 on_a = point_on(body_of(world, a), point_a), on_b = point_on(body_of(world, b), point_b);

  const auto ask = [=](const Body& first, const Body& second, const TimeStep& now, Equations& equations) {
    const Vec3 p_a = point_of(first, on_a), p_b = point_of(second, on_b);
    const Real apart = (p_b - p_a).norm();
    const Vec3 n = apart > 0 ? Vec3((p_b - p_a) / apart) : Vec3::UnitY();  // coincident, so any direction is correct
    const Real begin = length_at(now.time), end = length_at(now.time + now.dt);
    require_positive("length of a piston", end);
    equations.push_back({.jacobian = Jacobian::along(n, first, p_a, second, p_b),
                         .error = apart - begin,
                         .bias = -(end - begin) / now.dt,
                         .lo = -force,
                         .hi = force});
  };
  const auto line = [=](const Body& first, const Body& second) {
    return std::vector<Vec3>{point_of(first, on_a), point_of(second, on_b)};
  };
  return {name, a, b, ask, line, true};
}

}  // namespace pushback
