/// The components of a step. Its order is in step.h.
#pragma once

#include <utility>
#include <vector>

#include "pushback/common/world/step_solver.h"

namespace pushback {

/// Selects the bodies that take part in a step and finds their contacts. This type selects all bodies.
struct AllBodies {
  Workers* workers = &alone();

  static void check(World& world) {
    check_places(world);
    for (const Body& body : world.bodies) check_state(body);
    for (Body& body : world.bodies) body.refresh_inertia();  // in case an orientation has been set by hand
  }
  void find_contacts(World& world, const Margin& margin = {}) const { world.find_contacts(margin, *workers); }
  /// Calls `act` for each body. `act` may change its body but must not read others.
  template <class Act>
  void each(World& world, const Act& act) const {
    workers->each(world.bodies.size(), 64, [&](Part part) {
      for (std::size_t i = part.begin; i < part.end; ++i) act(world.bodies[i]);
    });
  }
  static void end(World&, Real /*dt*/) {}
};

/// The forces of the substeps after the first. Forces that were set on bodies by hand last for the whole step, and each Force acts
/// on the present state of the bodies. Neither acts on sleeping bodies.
class ForcesOfSubsteps {
 public:
  /// Call it before any Force has acted.
  ForcesOfSubsteps(const World& world, const Plan& plan);
  /// Restores the forces set by hand. Called before contacts are detected again.
  void apply_by_hand(World& world) const;
  /// Restores the forces set by hand and applies each Force.
  void apply(World& world) const;
  /// Whether one of the forces may turn a body.
  bool turn_bodies(const World& world) const;

 private:
  std::vector<std::pair<Vec3, Vec3>> by_hand_;  // force and torque of each body, or empty if not needed
};

/// Makes the contacts World::contacts_before, with the impulses of the latest substep.
void remember_contacts(World& world);

/// Replaces the impulses of a step by the impulses of its last substep, from which solvers warm start. Removes contacts that have
/// parted, and contacts of bodies that are no longer in World::bodies.
void start_from_last_substep(World& world);

/// The impulses applied at each contact in one step, summed over its detections.
class ImpulseSums {
 public:
  /// Call it after the substeps of each detection.
  void add(const World& world);
  /// Call it after the last `add`. Writes the sums to World::contacts, which then also list the contacts that acted and have parted.
  void write_to(World& world);

 private:
  Contacts sums_;  // so far, ascending by id
};

}  // namespace pushback
