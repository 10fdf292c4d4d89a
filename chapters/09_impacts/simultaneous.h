/// Simultaneous impacts, solved to convergence.
#pragma once

#include "pushback/chapters/09_impacts/from_surface.h"

namespace pushback {

/// Replaces RestitutionFromSurface, and comes before Friction in the list. In a step in which a contact bounces, each sweep
/// repeats the normals until they are solved. An impact lasts one step, so no later step corrects an error of its sweeps.
///
/// The counterpart of SequentialImpacts. If a ball at 5 m/s hits a row of four equal balls, the five leave with -3, 2, 2, 2 and
/// 2 m/s.
struct SimultaneousImpacts : RestitutionFromSurface {
  Real precision = Real(1e-6);  ///< relative to the fastest bounce: the largest change of a speed that ends the rounds
  int most_rounds = 1000;       ///< per sweep

  void sweep(auto& step) {
    Real change = fastest_;
    for (int round = 0; round < most_rounds && change > precision * fastest_; ++round) {
      change = 0;
      for (std::size_t i = 0; i < step.contacts.size(); ++i) {
        Row& normal = step.rows[i];
        const Real before = normal.impulse;
        step.solve(i);
        change = std::max(change, std::abs(normal.impulse - before) / normal.effective_mass);
      }
      rows_solved += step.contacts.size();
    }
  }
};

}  // namespace pushback
