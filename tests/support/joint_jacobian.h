/// What a joint says of its equations against what becomes of them when the bodies move.
#pragma once

#include <cmath>

#include "pushback/common/bodies/random.h"
#include "pushback/common/world/joint.h"

/// Moved for t seconds by the velocities that it has: x + t v, R(t w) q. Exact, unlike a simulated step.
inline pushback::Body drifted(pushback::Body body, pushback::Real t) {
  const pushback::Real speed = body.angular_velocity.norm();
  body.position += t * body.velocity;
  if (speed > 0) {
    body.orientation =
        pushback::Quat(Eigen::AngleAxis<pushback::Real>(t * speed, body.angular_velocity / speed)) * body.orientation;
  }
  return body;
}

inline pushback::Equations asked_by(const pushback::Joint& joint, const pushback::Body& a, const pushback::Body& b,
                                    const pushback::TimeStep& now = {0, pushback::Real(1) / 60}) {
  pushback::Equations equations;
  joint.ask(a, b, now, equations);
  return equations;
}

/// J V.
inline pushback::Real rate_of(const pushback::Equation& equation, const pushback::Body& a, const pushback::Body& b) {
  const pushback::Jacobian& J = equation.jacobian;
  return J.n.dot(b.velocity - a.velocity) + J.rb_n.dot(b.angular_velocity) - J.ra_n.dot(a.angular_velocity);
}
