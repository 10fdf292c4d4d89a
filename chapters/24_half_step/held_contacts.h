/// Contacts in two stages: gaps are not to be below 0 after the drift, and speeds not when it is over.
#pragma once

#include "pushback/chapters/17_direct_contacts/warm_direct_contacts.h"

namespace pushback {

/// All contacts solved directly (chapter 17), each stage from the impulses of the one before:
///
///   positions     gap + h J v >= 0,  lambda >= 0      along J where the drift begins; what sticks has not slid when it ends
///   velocities    J v >= 0,          lambda >= 0      along J where the bodies are, for those that touch there
///
/// with friction inside the cone in both. Where bodies have met in this step, faster than `threshold`, the second is
/// J v >= -e v_n, v_n before the step.
class HeldContacts {
 public:
  Real threshold = Real(0.1);  ///< m/s; what arrives slower does not bounce

  HeldContacts();
  /// Makes World::contacts anew. What each bore in the latest step comes from World::contacts_before.
  void begin(World& world, const Margin& margin);
  /// The first stage. Throws InvalidInput where it cannot be solved.
  void press(World& world, Real h);
  /// The contacts where the bodies are now, and which of them touch.
  void detect(World& world, const Margin& margin);
  /// The second.
  void project(World& world, Real h);
  /// Contact::impulse: what acted since `begin`; and Contact::state.
  void report(World& world) const;

  int rows() const { return static_cast<int>(rows_.size()); }

 private:
  struct Known {  // of a contact, by its id
    ContactId id;
    Vec3 borne = Vec3::Zero();  // N, in the stage before
    Vec3 total = Vec3::Zero();  // N s, since `begin`
    Real approach = 0;          // J v as the step began, m/s
    bool pressed = false;       // in the first stage
  };
  void look(const World& world);
  void place(World& world);
  void solve(World& world, Real h);

  WarmDirectContacts direct_;
  Contacts touching_;  // that take part in a stage
  Rows rows_;
  std::vector<Known> known_, known_before_;  // of World::contacts, ascending
  std::vector<std::size_t> which_;           // of each of touching_, its place there
};

}  // namespace pushback
