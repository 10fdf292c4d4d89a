/// The lecture's approximation of friction, for comparison.
#pragma once

#include "pushback/chapters/06_friction/friction.h"

namespace pushback {

/// Uses the lecture's bound mu m g, whatever load the contact carries. m is the lighter body's mass, divided among the pair's points.
struct FrictionByWeight : Friction {
  std::vector<Real> bound;
  void build(StepContext& step) {
    Friction::build(step);
    bound.clear();
    for (const Contact& contact : step.contacts) {
      const auto same_pair = [&](const Contact& other) {
        return other.id.body_a == contact.id.body_a && other.id.body_b == contact.id.body_b;
      };
      const auto points = static_cast<Real>(std::count_if(step.contacts.begin(), step.contacts.end(), same_pair));
      const auto [a, b] = step.world.bodies_of(contact);
      const Real mass = 1 / std::max(a.inverse_mass, b.inverse_mass);
      bound.push_back(contact.friction * mass / points * World::g * step.dt);
    }
  }
  void sweep(StepContext& step) {
    for (std::size_t i = first_; i < step.rows.size(); ++i) {
      Row& tangent = step.rows[i];
      tangent.hi = bound[tangent.owner];
      tangent.lo = -tangent.hi;
      tangent.solve();
    }
    rows_solved += step.rows.size() - first_;
  }
};

}  // namespace pushback
