/// The push-out as a second set of velocities: used once, to move the bodies, and then forgotten.
#pragma once

#include "pushback/chapters/03_baumgarte/baumgarte.h"
#include "pushback/chapters/10_position_correction/correcting_solver.h"
#include "pushback/chapters/10_position_correction/displace.h"

namespace pushback {

/// Instead of Baumgarte, with Slop or without. The contacts' rows once more, for pseudo-velocities V' that start from 0:
///
///   J V' + b' = 0,   b' = (beta / h) min(0, C + h J V)      C + h J V: minus the overlap once moved, to first order
///   then  x += h v',  q += h/2 (0, w') q                    and v, w are what they were
///
/// The method is that of Bullet's solver, "split impulse"; a correction apart from the velocities is older:
/// Cline and Pai, "Post-Stabilization for Rigid Body Simulation with Contact and Constraints", ICRA 2003.
struct SplitImpulse : Effect, Corrects {
  Real beta = Real(0.2);   ///< of 0 ... 1: how much of the overlap one step takes away
  Real most = Real(0.05);  ///< m; no contact corrects more in one step
  int rounds = 10;         ///< sweeps over the pseudo-velocities

  void check(StepContext&) {
    require_between("beta", beta, 0, 1);
    require_not_negative("most", most);
    if (rounds < 0) throw InvalidInput(fmt::format("rounds is {}: a whole number, 0 or more, is needed", rounds));
  }
  void correct(CorrectingContext& step) {
    pushes_.assign(step.rows.begin(), step.rows.begin() + std::ssize(step.contacts));
    bool overlap = false;
    for (Row& push : pushes_) {
      push.impulse = 0;
      push.bias = 0;
      if (push.separation == 0) continue;
      const Real left = std::min(Real(0), push.separation + step.dt * push.speed());
      push.bias = std::max(beta * left, -most) / step.dt;
      overlap = overlap || left < 0;
    }
    if (!overlap) return;
    set_velocities_aside();
    for (int round = 0; round < rounds; ++round) {
      for (Row& push : pushes_) push.solve();
      rows_solved += pushes_.size();
    }
    for (const Aside& body : aside_) {
      displace(*body.of, step.dt * body.of->velocity, step.dt * body.of->angular_velocity);
      body.of->velocity = body.velocity;
      body.of->angular_velocity = body.angular_velocity;
    }
  }

 private:
  struct Aside {
    Body* of;
    Vec3 velocity, angular_velocity;
  };
  /// A row reads its bodies' velocities, so V' = 0 is written there for the rounds. Each body once.
  void set_velocities_aside() {
    aside_.clear();
    for (const Row& push : pushes_) {
      for (Body* body : {push.a, push.b}) aside_.push_back({body, body->velocity, body->angular_velocity});
    }
    std::sort(aside_.begin(), aside_.end(), [](const Aside& p, const Aside& q) { return p.of->index < q.of->index; });
    aside_.erase(std::unique(aside_.begin(), aside_.end(), [](const Aside& p, const Aside& q) { return p.of == q.of; }),
                 aside_.end());
    for (const Aside& body : aside_) {
      body.of->velocity.setZero();
      body.of->angular_velocity.setZero();
    }
  }

  Rows pushes_;               // the normals, for V'
  std::vector<Aside> aside_;  // whom they touch, and v and w meanwhile
};

}  // namespace pushback
