/// Restitution makes bodies separate e times as fast as they approached.
#pragma once

#include "pushback/chapters/04_slop/slop.h"

namespace pushback {

/// v_n before the step, m/s, before any of its impulses and its gravity, because the body has not fallen by that gravity yet.
inline Real approach_speed(const World& world, const Contact& at) {
  const auto [a, b] = world.bodies_of(at);
  const auto before = [&](const Body& body) -> Vec3 {
    return body.velocity_before + body.angular_velocity_before.cross(at.point - body.position);
  };
  return (before(b) - before(a)).dot(at.normal);
}

/// b = min(b, e v_n) keeps the larger of bounce and push-out, not their sum.
struct Restitution : Effect {
  Real threshold = Real(0.1);  ///< m/s; a body that arrives slower does not bounce

  void check(StepContext&) { require_not_negative("threshold", threshold); }
  void build(StepContext& step) {
    for (std::size_t i = 0; i < step.contacts.size(); ++i) {
      const Contact& at = step.contacts[i];
      const Real approach = approach_speed(step.world, at);
      if (approach < -threshold) step.rows[i].bias = std::min(step.rows[i].bias, at.restitution * approach);
    }
  }
};

}  // namespace pushback
