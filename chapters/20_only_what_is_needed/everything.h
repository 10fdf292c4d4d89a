/// A solver with all effects at all contacts, for a comparison of costs.
#pragma once

#include "pushback/chapters/14_joints_under_load/jointed_solver.h"

namespace pushback {

/// Chapter 06's Friction builds no rows for a contact with mu = 0. This effect does, with both limits 0.
struct FrictionEverywhere : Friction {
  void build(StepContext& step) {
    first_ = step.rows.size();
    mu_.clear();
    for (std::size_t i = 0; i < step.contacts.size(); ++i) {
      const Contact& at = step.contacts[i];
      const auto [tangent1, tangent2] = tangents_of(at.normal);
      for (const Vec3& tangent : {tangent1, tangent2}) {
        step.rows.emplace_back(step.world, at, tangent, i);
        if (at.friction == 0) step.rows.back().lo = step.rows.back().hi = 0;
      }
      mu_.push_back(at.friction);
    }
  }
  void report(StepContext& step) {
    Friction::report(step);
    for (Contact& contact : step.contacts) {
      if (contact.friction == 0) contact.state = ContactState::fresh;  // neither sticking nor sliding: no friction
    }
  }
};

using Everything = Solver<SplitJoints, Clamping, Baumgarte, Slop, Restitution, FrictionEverywhere, WarmStart>;

}  // namespace pushback
