/// Bounce: part as fast as e times the speed of approach.
#pragma once

#include "chapters/04_slop/slop.h"

namespace pushback {

/// v_n before the step: before any impulse of it, and before its gravity, which the body has not yet fallen by.
inline Real approach_speed(const Contact& at) {
  const auto before = [&](const Body& body) -> Vec3 {
    return body.velocity_before + body.angular_velocity_before.cross(at.point - body.position);
  };
  return (before(*at.b) - before(*at.a)).dot(at.normal);
}

/// b = min(b, e v_n): whichever asks for more, the bounce or the push-out; not their sum.
struct Restitution : Effect {
  Real threshold = Real(0.1);  ///< m/s; what arrives slower stays

  void build(const Contacts& contacts, Rows& rows, Real) {
    require_not_negative("threshold", threshold);
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      const Real approach = approach_speed(contacts[i]);
      if (approach < -threshold) rows[i].bias = std::min(rows[i].bias, contacts[i].restitution * approach);
    }
  }
};

}  // namespace pushback
