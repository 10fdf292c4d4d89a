/// Start from where the last step ended: what held a contact then will very nearly hold it now.
#pragma once

#include "chapters/06_friction/friction.h"

namespace pushback {

/// sum(lambda) starts from what the same contact point had one step before, scaled by dt_new / dt_old.
///
/// `report` remembers; `build` of the next step finds the points again by their ids; `start` applies.
///
/// Remembered is the impulse as a vector in world axes. Each row takes the part along its own direction, so nothing has to
/// be said of normals and tangents, and tangents may turn from step to step.
struct WarmStart : Effect {
  void build(const Contacts& contacts, Rows&, Real dt) {
    const Real scale = last_dt_ > 0 ? dt / last_dt_ : 0;
    last_dt_ = dt;
    known_.assign(contacts.size(), false);
    first_guess_.assign(contacts.size(), Vec3::Zero());
    auto old = memory_.begin();  // both lists ascend: walk them side by side
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      while (old != memory_.end() && old->id < contacts[i].id) ++old;
      if (old == memory_.end() || old->id != contacts[i].id) continue;
      known_[i] = true;
      first_guess_[i] = scale * old->impulse;
    }
  }
  void start(Rows& rows) {
    for (Row& row : rows) row.reach(first_guess_[static_cast<std::size_t>(row.contact)].dot(row.n));
  }
  void report(Contacts& contacts, const Rows&) {
    memory_.clear();
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      memory_.push_back({contacts[i].id, contacts[i].impulse});
      if (!known_[i]) contacts[i].state = ContactState::fresh;
      else if (contacts[i].state == ContactState::fresh) contacts[i].state = ContactState::warm;
    }
  }
  /// After a teleport, or in another world.
  void forget() { memory_.clear(); }
  /// As if these had been contacts of the latest step, beside its own.
  void remember(const Contacts& contacts) {
    for (const Contact& contact : contacts) memory_.push_back({contact.id, contact.impulse});
    std::sort(memory_.begin(), memory_.end(), [](const Memory& p, const Memory& q) { return p.id < q.id; });
  }

 protected:
  struct Memory {
    ContactId id;
    Vec3 impulse;
  };
  std::vector<Memory> memory_;
  std::vector<Vec3> first_guess_;
  std::vector<bool> known_;
  Real last_dt_ = 0;
};

}  // namespace pushback
