/// Other ways to bounce: two of them mistaken, one that keeps the bounce apart.
#pragma once

#include "chapters/05_restitution/restitution.h"

namespace pushback {

/// A mistake: bounce and push-out added up.
struct RestitutionAdded : Effect {
  void build(const Contacts& contacts, Rows& rows, Real) {
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      const Real approach = approach_speed(contacts[i]);
      if (approach < 0) rows[i].bias += contacts[i].restitution * approach;
    }
  }
};

/// Half a mistake: an approach speed that already has in it the gravity of this step, which the ball has not fallen by.
struct RestitutionWithGravity : Effect {
  Real threshold = 0;
  void build(const Contacts& contacts, Rows& rows, Real) {
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      const Real approach = rows[i].speed();
      if (approach < -threshold) rows[i].bias = std::min(rows[i].bias, contacts[i].restitution * approach);
    }
  }
};

/// Kept apart: the sweeps stop the approach and push out; when they are done, a pass of its own makes the contacts bounce.
struct RestitutionApart : Effect {
  std::vector<Real> departure;
  void build(const Contacts& contacts, Rows&, Real) {
    departure.clear();
    for (const Contact& contact : contacts)
      departure.push_back(-contact.restitution * std::min(Real(0), approach_speed(contact)));
  }
  void finish(Rows& rows) {
    for (std::size_t i = 0; i < departure.size(); ++i) {
      if (rows[i].impulse == 0 || departure[i] == 0) continue;
      rows[i].bias = -departure[i];
      rows[i].solve();
      ++rows_solved;
    }
  }
};

}  // namespace pushback
