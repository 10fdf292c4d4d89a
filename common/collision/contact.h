/// What collision detection tells a solver, and what the solver tells the pictures.
#pragma once

#include <compare>
#include <cstdint>
#include <vector>

#include "pushback/common/bodies/body.h"

namespace pushback {

/// Names a contact point by what touches, not by where: the same two bodies, the same corner, edge or face, have the
/// same id in the next step. Ordered, so that two steps' contacts can be matched by walking both lists once.
struct ContactId {
  std::uint32_t body_a = 0;   ///< Body::index; body_a < body_b
  std::uint32_t body_b = 0;   ///< Body::index
  std::uint32_t feature = 0;  ///< which features of the two shapes meet
  auto operator<=>(const ContactId&) const = default;
};

/// What the solver did with a contact point in the latest step.
enum class ContactState {
  fresh,     ///< started from nothing
  warm,      ///< started from the impulse it had one step before
  sliding,   ///< friction is at its bound
  sticking,  ///< friction holds
};

/// One point at which two bodies overlap.
struct Contact {
  Vec3 point = Vec3::Zero();   ///< m, world axes: midway between the two surfaces
  Vec3 normal = Vec3::Zero();  ///< unit, world axes, always from A to B
  Real depth = 0;              ///< m, positive when overlapping: -(P_B - P_A) . n; negative within a margin
  Real friction = 0;           ///< mu of the pair
  Real restitution = 0;        ///< e of the pair
  bool ahead = false;  ///< n is not that between what is nearest now, but that with which they would touch: see Margin
  /// It acted earlier in the step and was not detected again. All but `impulse` is as it was when it last acted.
  bool parted = false;
  ContactId id;  ///< and with it which bodies: A is id.body_a, B is id.body_b

  /// N s, on B, world axes: the momentum that B gained and A lost here in the latest step, over all its substeps. In
  /// World::contacts_before, and while a solver is at work: what one substep applied.
  Vec3 impulse = Vec3::Zero();
  /// N s, on B, world axes: what the step's last substep applied, from which the next step starts. 0 if it has parted.
  Vec3 last_impulse = Vec3::Zero();
  ContactState state = ContactState::fresh;  ///< what the solver did here
};

using Contacts = std::vector<Contact>;

}  // namespace pushback
