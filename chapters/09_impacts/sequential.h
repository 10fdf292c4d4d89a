/// Sequential impacts: each pair passes its speed on before the next pair is solved.
#pragma once

#include "pushback/chapters/05_restitution/restitution.h"

namespace pushback {

/// Instead of Restitution, and like it before WarmStart. Every pair that approaches bounces as if nothing else touched it,
/// again and again until no pair approaches:   lambda = -(v_n + e v_n) / K,   v_n: when it is solved, without this step's forces.
///
/// Simultaneous and sequential impacts both obey Newton's rule, and differ. A ball that hits a row of equal ones sends off all
/// of them if the impacts are simultaneous, and only the last if they are sequential. Steel balls are closer to sequential.
struct SequentialImpacts : Effect {
  Real threshold = Real(0.1);  ///< m/s; a body that arrives slower does not bounce
  int most_rounds = 1000;      ///< then the sweeps have to do with what is left

  void check(StepContext&) { require_not_negative("threshold", threshold); }
  void build(StepContext& step) {
    bouncing_.clear();
    for (std::size_t i = 0; i < step.contacts.size(); ++i) {
      const Contact& at = step.contacts[i];
      if (at.restitution == 0) continue;
      bouncing_.push_back({i, at.restitution, step.rows[i].speed() - approach_speed(step.world, at)});
    }
  }
  /// From here on the row may add to its impact but not take it back: lo = impulse.
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
    Real by_forces;  // what this step's forces have added to v_n, m/s
  };
  std::vector<Bouncing> bouncing_;
};

}  // namespace pushback
