/// Contacts. Collision detection finds their points, normals and depths. The solver adds their impulses and states.
#pragma once

#include <compare>
#include <cstdint>
#include <vector>

#include "pushback/common/bodies/body.h"

namespace pushback {

/// Identifies a contact point by its features, not by its position. The same corner, edge or face of the same two bodies has the
/// same id in the next step. Ids are ordered, so that one pass over both lists matches the contacts of two steps.
struct ContactId {
  std::uint32_t body_a = 0;   ///< Body::index; body_a < body_b
  std::uint32_t body_b = 0;   ///< Body::index
  std::uint32_t feature = 0;  ///< which features of the two shapes meet
  auto operator<=>(const ContactId&) const = default;
};

/// The solver's result at a contact point in the latest step.
enum class ContactState {
  fresh,     ///< started from impulse 0
  warm,      ///< started from the impulse it had one step before
  sliding,   ///< friction is at its bound
  sticking,  ///< friction holds
};

/// One point at which two bodies overlap, or are apart within a margin.
struct Contact {
  Vec3 point = Vec3::Zero();   ///< m, world axes: midway between the two surfaces
  Vec3 normal = Vec3::Zero();  ///< unit, world axes, always from A to B
  Real depth = 0;              ///< m, positive when overlapping: -(P_B - P_A) . n; negative within a margin
  Real friction = 0;           ///< mu of the pair
  Real restitution = 0;        ///< e of the pair
  /// Whether n is the normal with which the bodies would touch, not the normal between the closest features now: see Margin.
  bool ahead = false;
  /// The contact acted earlier in the step and was not detected again. All members but the impulses are as it last acted.
  bool parted = false;
  ContactId id;  ///< also gives the bodies: A is id.body_a, B is id.body_b

  /// The momentum that B gained and A lost here in the latest step, over all its substeps, N s, world axes. In
  /// World::contacts_before, and while a solver is at work, the impulse on B in one substep.
  Vec3 impulse = Vec3::Zero();
  /// The impulse on B in the step's last substep, from which the next step warm starts, N s, world axes. 0 if the contact has parted.
  Vec3 last_impulse = Vec3::Zero();
  ContactState state = ContactState::fresh;
};

using Contacts = std::vector<Contact>;

}  // namespace pushback
