/// A step starts from the final impulses of the previous step, because they almost solve this step as well.
#pragma once

#include "pushback/chapters/06_friction/friction.h"

namespace pushback {

/// sum(lambda) starts from its value at the same contact point in the previous step, scaled by dt_new / dt_old.
///
/// A contact keeps its impulse as a vector in world axes. `build` finds the points of the previous step by their ids. Each row
/// takes the component along its own direction, so normals and tangents are treated alike, and tangents may rotate from step to
/// step.
struct WarmStart : Effect {
  void build(StepContext& step) {
    const Contacts &contacts = step.contacts, &before = step.world.contacts_before;
    const Real scale = step.world.impulse_scale(step.dt);
    known_.assign(contacts.size(), false);
    first_guess_.assign(contacts.size(), Vec3::Zero());
    auto old = before.begin();  // both lists ascend, so go through them in parallel
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      while (old != before.end() && old->id < contacts[i].id) ++old;
      if (old == before.end() || old->id != contacts[i].id) continue;
      known_[i] = true;
      first_guess_[i] = scale * old->impulse;
    }
  }
  void start(StepContext& step) {
    for (Row& row : step.rows) row.reach(first_guess_[row.owner].dot(row.n));
  }
  void report(StepContext& step) {
    for (std::size_t i = 0; i < known_.size(); ++i) {
      ContactState& state = step.contacts[i].state;
      if (!known_[i]) state = ContactState::fresh;
      else if (state == ContactState::fresh) state = ContactState::warm;
    }
  }

 protected:
  std::vector<Vec3> first_guess_;  // N s, for each contact
  std::vector<bool> known_;        // for each contact, whether the previous step had it
};

}  // namespace pushback
