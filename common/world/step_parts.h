/// What a step is made of, beside its order.
#pragma once

#include <utility>
#include <vector>

#include "pushback/common/world/step_solver.h"

namespace pushback {

/// Who takes part in a step, and finds what touches. This one leaves nobody out.
struct Everybody {
  Workers* workers = &alone();

  static void check(World& world) {
    check_places(world);
    for (const Body& body : world.bodies) check_state(body);
    for (Body& body : world.bodies) body.refresh_inertia();  // of one whose orientation has been set by hand
  }
  void find_contacts(World& world, const Margin& margin = {}) const { world.find_contacts(margin, *workers); }
  /// `act` changes its body and reads no other.
  template <class Act>
  void each(World& world, const Act& act) const {
    workers->each(world.bodies.size(), 64, [&](Part part) {
      for (std::size_t i = part.begin; i < part.end; ++i) act(world.bodies[i]);
    });
  }
  static void end(World&, Real /*dt*/) {}
};

/// The forces of the substeps after the first: what was put on bodies by hand lasts for the step, and each Force acts on the
/// bodies as they are now. A sleeping body feels neither.
class ForcesOfSubsteps {
 public:
  /// Before any Force has acted.
  ForcesOfSubsteps(const World& world, const Plan& plan);
  /// What was put on bodies by hand, before contacts are detected again.
  void apply_by_hand(World& world) const;
  void apply(World& world) const;
  /// Whether one of them may turn a body.
  bool turn_bodies(const World& world) const;

 private:
  std::vector<std::pair<Vec3, Vec3>> by_hand_;  // force and torque of each body; none where nobody has any
};

/// Makes contacts_before of the contacts, with what the latest substep applied there.
void remember_contacts(World& world);

/// The impulses of a step become those of its last substep, from which solvers start. What has parted is no contact any more, nor is
/// what touched a body that is gone.
void start_from_last_substep(World& world);

/// What was applied at each contact in one step, summed over its detections.
class ImpulseSums {
 public:
  /// Once the substeps since a detection are over.
  void add(const World& world);
  /// After the last of them: World::contacts get the sums, and what acted and has parted is listed as well.
  void write_to(World& world);

 private:
  Contacts sums_;  // so far, ascending
};

}  // namespace pushback
