/// A spring with a damper, made of any equation.
#pragma once

#include "pushback/chapters/13_joints/distance.h"
#include "pushback/chapters/15_limits_motors_springs/angle.h"

namespace pushback {

/// A spring on which the effective mass oscillates at `hertz`. `damping_ratio`: zeta, 0 for undamped, 1 for critically damped.
struct Spring {
  Real hertz, damping_ratio;
};
inline void check(const std::string& joint, const Spring& spring) {
  require_positive("hertz of " + joint, spring.hertz);
  require_not_negative("damping ratio of " + joint, spring.damping_ratio);
}

/// K = J M^-1 J^T of an equation, 1/kg or 1/(kg m^2).
inline Real k_of(const Body& a, const Body& b, const Equation& row) {
  const Jacobian& J = row.jacobian;
  const Real linear = J.n.isZero(0) ? 0 : a.inverse_mass + b.inverse_mass;
  return linear + J.ra_n.dot(a.inverse_inertia * J.ra_n) + J.rb_n.dot(b.inverse_inertia * J.rb_n);
}

/// Replaces the rigid equation by a spring and a damper. Only they feed back its error C.
///
///   m = 1/K,  w = 2 pi hertz,  k = m w^2,  c = 2 m zeta w         m: the row's effective mass
///   J V + b + gamma lambda = 0,  gamma = 1 / (h (c + h k)),  b = h k gamma C         -k C - c C', at the end of the step
///
/// Catto, "Soft Constraints", GDC 2011.
inline Equation soft(Equation row, const Spring& spring, const Body& a, const Body& b, Real dt) {
  const Real m = 1 / k_of(a, b, row), w = 2 * pi * spring.hertz;
  const Real k = m * w * w, c = 2 * m * spring.damping_ratio * w;
  row.softness = 1 / (dt * (c + dt * k));
  row.bias = dt * k * row.softness * row.error;
  row.error = 0;
  return row;
}

/// The joint with this spring in each of its equations.
inline Joint soft(Joint rigid, const Spring& spring) {
  rigid.name += " with a spring";
  check(rigid.name, spring);
  rigid.ask = [ask = rigid.ask, spring](const Body& a, const Body& b, const TimeStep& now, Equations& equations) {
    const std::size_t first = equations.size();
    ask(a, b, now, equations);
    for (std::size_t i = first; i < equations.size(); ++i) equations[i] = soft(equations[i], spring, a, b, now.dt);
  };
  return rigid;
}

/// Turns B about `axis` (world axes) back to its current orientation relative to A.
inline Joint torsion_spring(const World& world, int a, int b, const Vec3& axis, const Spring& spring) {
  const std::string name = "a torsion";
  check_joined(world, name, a, b);
  const HingeAngle angle(world, a, b, unit_axis(name, axis));
  const auto ask = [=](const Body& first, const Body& second, const TimeStep&, Equations& equations) {
    const Angle turned = angle.of(first, second);
    equations.push_back(turning(turned.gradient));
    equations.back().error = turned.value;
  };
  return soft({name, a, b, ask}, spring);
}

}  // namespace pushback
