/// The lecture's approximation of friction, to be compared.
#pragma once

#include "chapters/06_friction/friction.h"

namespace pushback {

/// The lecture's bound: mu m g, whatever the contact carries. Each point is given its share of the lighter body's mass.
struct FrictionByWeight : Friction {
  std::vector<Real> bound;
  void build(const Contacts& contacts, Rows& rows, Real dt) {
    Friction::build(contacts, rows, dt);
    bound.clear();
    for (const Contact& contact : contacts) {
      const auto same_pair = [&](const Contact& other) { return other.a == contact.a && other.b == contact.b; };
      const auto points = static_cast<Real>(std::count_if(contacts.begin(), contacts.end(), same_pair));
      const Real mass = 1 / std::max(contact.a->inverse_mass, contact.b->inverse_mass);
      bound.push_back(contact.friction * mass / points * Real(9.81) * dt);
    }
  }
  void sweep(Rows& rows) {
    for (std::size_t i = first_; i < rows.size(); ++i) {
      rows[i].hi = bound[rows[i].contact];
      rows[i].lo = -rows[i].hi;
      rows[i].solve();
    }
    rows_solved += rows.size() - first_;
  }
};

}  // namespace pushback
