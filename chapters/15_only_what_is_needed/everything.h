/// What a solver costs that does everything everywhere; to be compared.
#pragma once

#include "chapters/09_joints/jointed_solver.h"

namespace pushback {

/// Chapter 06's Friction makes no rows for a contact with mu = 0. This one does; their limits are 0 and 0.
struct FrictionEverywhere : Friction {
  void build(const Contacts& contacts, Rows& rows, Real) {
    first_ = rows.size();
    mu_.clear();
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      const auto [tangent1, tangent2] = tangents_of(contacts[i].normal);
      for (const Vec3& tangent : {tangent1, tangent2}) {
        Row& row = rows.emplace_back(contacts[i], tangent, static_cast<int>(i));
        if (contacts[i].friction == 0) row.lo = row.hi = 0;
      }
      mu_.push_back(contacts[i].friction);
    }
  }
  void report(Contacts& contacts, const Rows& rows) {
    Friction::report(contacts, rows);
    for (Contact& contact : contacts) {
      if (contact.friction == 0) contact.state = ContactState::fresh;  // neither held nor sliding: nothing rubs
    }
  }
};

using Everything = Solver<SplitJoints, Clamping, Baumgarte, Slop, Restitution, FrictionEverywhere, WarmStart>;

}  // namespace pushback
