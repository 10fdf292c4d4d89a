/// What a step is made of, beside its order.
#pragma once

#include <utility>
#include <vector>

#include "pushback/common/world/step_solver.h"

namespace pushback {

/// Who takes part in a step, and finds what touches. This one leaves nobody out.
struct Everybody {
  Workers* workers = &alone();

  static void check(const World& world) {
    for (const Body& body : world.bodies) check_state(body);
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
  void apply(World& world) const;
  /// Whether one of them may turn a body.
  bool turn_bodies(const World& world) const;

 private:
  std::vector<std::pair<Vec3, Vec3>> by_hand_;  // force and torque of each body; none where nobody has any
};

/// Makes contacts_before of the contacts, with what the latest substep applied there.
void remember_contacts(World& world);

/// What was applied at each contact in one step, summed over its detections.
class ImpulseSums {
 public:
  /// Before contacts are detected anew.
  void keep(const World& world);
  /// Once the substeps since a detection are over.
  void add(World& world, const Plan& plan);

 private:
  std::vector<std::pair<ContactId, Vec3>> sums_;  // N s, so far; ascending
};

}  // namespace pushback
