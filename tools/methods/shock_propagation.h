/// Shock propagation: a last pass from the ground upwards, in which what is below stands as if nothing could move it.
#pragma once

#include "pushback/chapters/08_friction_cone/friction_cone.h"

namespace pushback {

/// After the sweeps, and in the list after friction. The height of a body is the least number of contacts from it down to one that
/// nothing moves. Contacts are solved once more in the order of the lower of their two heights, those of a height `rounds` times; if
/// the heights differ, with M^-1 = 0 for the lower body:
///
///   lambda_n = -(J V + b) / K',   sum >= 0;     lambda_t = -J_t V / k',   in the disc of mu sum(lambda_n);     K', k': of the upper body
///
/// So a body carries what is above it without yielding, and momentum is not conserved: the lower body does not feel this pass. The
/// contact keeps the sum, from which the next step's warm start pushes both.
///   E. Guendelman, R. Bridson, R. Fedkiw, "Nonconvex Rigid Bodies with Stacking", SIGGRAPH 2003, section 7.3. Friction in that pass, and
///   sums that are kept, are ours: docs/a_solver_of_your_own.md has the pass without.
struct ShockPropagation : Effect {
  int rounds = 4;  ///< over the contacts of one height

  void check(StepContext&) {
    if (rounds < 0) throw InvalidInput(fmt::format("rounds is {}: a whole number, 0 or more, is needed", rounds));
  }
  void finish(StepContext& step);

 private:
  static constexpr int none = std::numeric_limits<int>::max();

  void find_heights(const StepContext& step);
  /// The same row, with the lower body as if nothing moved it.
  Row on_the_upper(const Row& row) const;

  std::vector<int> heights_;                        // of the bodies; none where nothing leads down from it
  std::vector<std::vector<std::size_t>> contacts_;  // by the lower of their two heights
  std::vector<std::size_t> tangents_;               // of each contact, the first of two rows; 0: it has none
};

}  // namespace pushback
