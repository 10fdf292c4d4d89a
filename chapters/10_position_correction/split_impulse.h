/// Split impulse pushes the bodies apart once by a second set of velocities, which is then discarded.
#pragma once

#include "pushback/chapters/03_baumgarte/baumgarte.h"
#include "pushback/chapters/10_position_correction/correcting_solver.h"
#include "pushback/chapters/10_position_correction/displace.h"

namespace pushback {

/// Replaces Baumgarte, with Slop or without. Solves the contacts' rows again, for pseudo-velocities V' that start from 0:
///
///   J V' + b' = 0,   b' = (beta / h) min(0, C + h J V)      C + h J V: the separation after the move, to first order
///   then  x += h v',  q += h/2 (0, w') q                    v and w do not change
///
/// Bullet's solver uses this method under the name "split impulse". Correcting positions apart from the velocities is older:
/// Cline and Pai, "Post-Stabilization for Rigid Body Simulation with Contact and Constraints", ICRA 2003.
struct SplitImpulse : Effect, Corrects {
  Real beta = Real(0.2);   ///< 0 ... 1: the fraction of the overlap that one step removes
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
  /// A row reads the velocities of its bodies, so V' = 0 replaces them during the rounds. Stores each body once.
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

  Rows pushes_;               // copies of the normals, for V'
  std::vector<Aside> aside_;  // their bodies, with the true v and w
};

}  // namespace pushback
