/// Sequential impacts, in which each pair bounces before the next pair is solved.
#pragma once

#include "pushback/chapters/05_restitution/restitution.h"

namespace pushback {

/// Replaces Restitution, and like it comes before WarmStart in the list. Each pair that approaches bounces as if nothing else
/// touched it. This is repeated until no pair approaches:
///
///   lambda = -(1 + e) v_n / K        v_n at the time of the solve, without the speed that this step's forces have added
///
/// Simultaneous and sequential impacts both obey Newton's rule, but their results differ. If a ball hits a row of equal balls,
/// simultaneous impacts send off the whole row, and sequential impacts only the last ball, as steel balls nearly do.
struct SequentialImpacts : Effect {
  Real threshold = Real(0.1);  ///< m/s; a body that arrives slower does not bounce
  int most_rounds = 1000;      ///< the sweeps solve the contacts that still approach after these rounds

  void check(StepContext&) { require_not_negative("threshold", threshold); }
  void build(StepContext& step) {
    bouncing_.clear();
    for (std::size_t i = 0; i < step.contacts.size(); ++i) {
      const Contact& at = step.contacts[i];
      if (at.restitution == 0) continue;
      bouncing_.push_back({i, at.restitution, step.rows[i].speed() - approach_speed(step.world, at)});
    }
  }
  /// Sets lo = impulse, so the sweeps can add to the impulse of an impact but not take it back.
  void start(StepContext& step) {
    bool again = true;
    for (int round = 0; again && round < most_rounds; ++round) {
      again = false;
      for (const Bouncing& at : bouncing_) {
        Row& row = step.rows[at.row];
        const Real approach = row.speed() - at.by_forces;
        if (approach >= -threshold) continue;
        row.reach(row.impulse - row.effective_mass * (1 + at.restitution) * approach);
        row.lo = row.impulse;
        ++rows_solved;
        again = true;
      }
    }
  }

 protected:
  struct Bouncing {
    std::size_t row;
    Real restitution;
    Real by_forces;  // the speed that this step's forces have added to v_n, m/s
  };
  std::vector<Bouncing> bouncing_;
};

}  // namespace pushback
