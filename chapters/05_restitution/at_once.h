/// Impacts all at once, solved until nothing changes any more.
#pragma once

#include "chapters/05_restitution/from_surface.h"

namespace pushback {

/// Like RestitutionFromSurface; but in a step in which something bounces, each sweep goes over the normals as often as it
/// takes. A blow lasts one step: what its sweeps leave unsolved, no later step makes up for. In the list before Friction.
///
/// The counterpart of ImpactsInTurn: a row of equal balls that touch, hit with 5 m/s, leaves with -3, 2, 2, 2, 2 m/s.
struct ImpactsAtOnce : RestitutionFromSurface {
  Real precision = Real(1e-6);  ///< of the fastest bounce; it ends where no row changes a speed by more
  int most_rounds = 1000;

  void build(const Contacts& contacts, Rows& rows, Real dt) {
    fastest_ = RestitutionFromSurface::build(contacts, rows, dt);
    normals_ = contacts.size();
  }
  void sweep(Rows& rows) {
    Real change = fastest_;
    for (int round = 0; round < most_rounds && change > precision * fastest_; ++round) {
      change = 0;
      for (std::size_t i = 0; i < normals_; ++i) {
        const Real before = rows[i].impulse;
        rows[i].solve();
        change = std::max(change, std::abs(rows[i].impulse - before) / rows[i].effective_mass);
      }
      rows_solved += normals_;
    }
  }

 private:
  std::size_t normals_ = 0;
  Real fastest_ = 0;  // m/s, 0: nothing bounces
};

}  // namespace pushback
