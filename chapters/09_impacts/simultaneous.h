/// Simultaneous impacts, solved to the end.
#pragma once

#include "pushback/chapters/09_impacts/from_surface.h"

namespace pushback {

/// Like RestitutionFromSurface; but in a step in which a contact bounces, each sweep repeats the normals until they are solved.
/// An impact lasts one step, so no later step corrects what its sweeps leave unsolved. In the list before Friction.
///
/// The counterpart of SequentialImpacts: a row of equal balls that touch, hit with 5 m/s, leaves with -3, 2, 2, 2, 2 m/s.
struct SimultaneousImpacts : RestitutionFromSurface {
  Real precision = Real(1e-6);  ///< of the fastest bounce; it ends where no row changes a speed by more
  int most_rounds = 1000;

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
