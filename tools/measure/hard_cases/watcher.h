/// Checks the invariants that must hold after every step, for any scene and any solver.
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "pushback/common/world/world.h"

namespace pushback {

/// Whether every number of the world's bodies and impulses is finite.
inline bool finite(const World& world) {
  for (const Body& body : world.bodies) {
    if (!body.position.allFinite() || !body.orientation.coeffs().allFinite()) return false;
    if (!body.velocity.allFinite() || !body.angular_velocity.allFinite()) return false;
  }
  for (const Contact& contact : world.contacts) {
    if (!contact.impulse.allFinite()) return false;
  }
  return true;
}

/// The limits of the invariants in a scene.
struct Allowance {
  Real energy = 0;           ///< J above the start, which push-outs may add
  Real overlap = Real(0.1);  ///< m
  bool isolated = false;     ///< no gravity, no contact with immovable bodies, so both momenta are constant
  Real epsilon = std::numeric_limits<Real>::epsilon();  ///< the rounding unit of the solver's numbers
};

/// Checks a world after every step. Stores the first violation, and over all steps the largest energy gain and the deepest overlap.
/// - Every number is finite.
/// - The energy is not above its start, unless a joint is driven, because a motor does work. The energy is the kinetic and potential
///   energy plus the term that makes the sum constant for a body in free fall by v += h g, x += h v. If h changes, each step is
///   compared with the sum for its own h.
/// - Momentum and angular momentum of an isolated system are constant up to rounding, unless a body is joined to an immovable one.
/// - No contact pulls, and along each tangent the friction of a contact is at most mu times its normal impulse.
/// - No overlap is deeper than allowed.
class Watcher {
 public:
  Watcher(const World& start, const Allowance& allowance);

  /// Call it after a step of dt, which had `substeps` substeps. `half_steps`: whether a body was moved by half steps, whose free flight
  /// keeps T + U without the extra term.
  void look(const World& world, Real dt, int substeps = 1, const std::function<bool(int body)>& half_steps = {});

  /// Call it within a step after a pass that a later pass will undo, because the rounding errors depend on the size of its numbers.
  void feel(const World& world);

  /// The first violation, in a few words with its value and the time, or empty.
  const std::string& broken() const { return broken_; }
  Real energy_gained() const { return energy_gained_; }  ///< J, the largest gain over the start
  Real deepest() const { return deepest_; }              ///< m, the deepest overlap of all steps

 private:
  void breaks(const std::string& how);

  /// The bound of rounding errors in the sums is proportional to the largest values of these so far, because errors persist.
  struct Sizes {
    Real energy = 0, momentum = 0, angular_momentum = 0;
    Real turning = 0;  // N m s, summed over the steps, because unequal inertias round off to the same side in each step
  };

  Allowance allowance_;
  Sizes sizes_;
  Vec3 momentum_, angular_momentum_;
  Real energy_;                // at the latest look: T + U, J,
  std::vector<Vec3> momenta_;  // and P of each body, kg m/s
  Real gained_ = 0;            // J, above the start, at the latest look
  Real time_ = 0;
  std::string broken_;
  Real energy_gained_ = 0, deepest_ = 0;
};

}  // namespace pushback
