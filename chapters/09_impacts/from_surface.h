/// The bounce of a body that is detected below the surface, computed as if it were at the surface.
#pragma once

#include "pushback/chapters/05_restitution/restitution.h"

namespace pushback {

/// Replaces Restitution. A step detects a body at a depth d, when it is already faster than when it touched the surface. On its
/// way out the body loses speed again. With e < 1 the two errors do not cancel. A body that falls and rises in steps of
///
///   v += h a,  x += h v    conserves    S = u^2 / 2 - a d + h a u / 2      u, a: its speed and acceleration into the surface
///
/// and 2 S is the square of its speed at the surface, where d = 0. The bounce has to leave e^2 of S:
///
///   v = -h a / 2 + sqrt((h a / 2)^2 + 2 (e^2 S + a d))          This is e u if a = 0, and u if e = 1.
///
/// A contact that bounces gets no push-out, because the bounce already separates its bodies.
struct RestitutionFromSurface : Effect {
  Real threshold = Real(0.1);  ///< m/s; a body that arrives slower does not bounce

  void check(StepContext&) { require_not_negative("threshold", threshold); }
  void build(StepContext& step) {
    fastest_ = 0;
    for (std::size_t i = 0; i < step.contacts.size(); ++i) {
      const Contact& at = step.contacts[i];
      const Real approach = approach_speed(step.world, at);
      if (approach >= -threshold || at.restitution == 0) continue;
      const Real depth = at.depth, e = at.restitution;
      const Real gained =
          std::max(Real(0), approach - step.rows[i].speed());  // h a, which this step's forces have added
      const Real a = gained / step.dt;
      const Real s = approach * approach / 2 - a * depth - gained * approach / 2;
      if (s <= 0) continue;  // too slow to have reached the surface, so it was pressed in and did not fall in
      const Real bounce = std::sqrt(gained * gained / 4 + 2 * (e * e * s + a * depth)) - gained / 2;
      step.rows[i].bias = -bounce;
      fastest_ = std::max(fastest_, bounce);
    }
  }

 protected:
  Real fastest_ = 0;  // the fastest bounce of the step, m/s; 0: nothing bounces
};

}  // namespace pushback
