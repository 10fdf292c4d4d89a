/// What must hold after every step, whatever the scene and the solver.
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "pushback/common/world/world.h"

namespace pushback {

/// Whether every number of its bodies and impulses is.
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

/// What a scene allows.
struct Allowance {
  Real energy = 0;           ///< J above the start: what push-outs may feed in
  Real overlap = Real(0.1);  ///< m
  bool isolated = false;     ///< no gravity, and nothing immovable is touched: momentum and angular momentum are kept
  Real epsilon = std::numeric_limits<Real>::epsilon();  ///< the rounding unit of the numbers that are computed with
};

/// Looks at a world after every step and keeps the first thing that was not as it must be, and to the end the most energy
/// gained and the deepest overlap:
/// - every number finite;
/// - energy not above the start, unless a joint is driven: a motor does work. Kinetic and potential energy together, with the term by
///   which a body in free fall differs from them when it moves by v += h g, x += h v: that sum free flight keeps exactly. Where h
///   changes, each step is held to the sum with its own h;
/// - momentum and angular momentum of an isolated system kept to rounding, unless something is joined to what is immovable:
///   that takes what it is given;
/// - no contact pulls, and none rubs by more than mu times what it presses, along each of its two tangents;
/// - no overlap deeper than allowed.
class Watcher {
 public:
  Watcher(const World& start, const Allowance& allowance);

  /// After a step of dt, which was `substeps` of dt / substeps. Of some bodies it may have been half steps, whose free flight keeps
  /// T + U itself: `half_steps` says of which.
  void look(const World& world, Real dt, int substeps = 1, const std::function<bool(int body)>& half_steps = {});

  /// Within a step, after a pass that another will take back: its numbers were this large, and were rounded so.
  void feel(const World& world);

  /// What broke first, in a few words with its number and the time; empty while all is well.
  const std::string& broken() const { return broken_; }
  Real energy_gained() const { return energy_gained_; }  ///< J, the most seen above the start
  Real deepest() const { return deepest_; }              ///< m, the deepest overlap seen

 private:
  void breaks(const std::string& how);

  /// What rounding can do to the sums is the most that these have been times a small number: errors once made stay.
  struct Sizes {
    Real energy = 0, momentum = 0, angular_momentum = 0;
    Real turning = 0;  // N m s, summed over the steps: uneven inertias round off anew, and to the same side, in each
  };

  Allowance allowance_;
  Sizes sizes_;
  Vec3 momentum_, angular_momentum_;
  Real energy_;                // as of the last look: T + U, J,
  std::vector<Vec3> momenta_;  // and of each body P, kg m/s
  Real gained_ = 0;            // J, above the start, as of the last look
  Real time_ = 0;
  std::string broken_;
  Real energy_gained_ = 0, deepest_ = 0;
};

}  // namespace pushback
