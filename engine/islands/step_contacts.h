/// The contacts of a step, from which islands are made.
#pragma once

#include <functional>

#include "pushback/common/collision/margin.h"
#include "pushback/common/world/step_solver.h"

namespace pushback {

/// The feature id of a pair that is near but has no contact.
inline constexpr std::uint32_t no_feature = std::numeric_limits<std::uint32_t>::max();

class StepClassifier;

/// All contacts within the margin, ascending.
class StepContacts {
 public:
  Contacts found;

  /// Finds the contacts within the plan's margin, and within the ways of the tips of free bodies that turn fast, because the margin follows
  /// the centres only. Bodies that Fast moved in the step `before` need none of the latter. World::contacts remain the contacts of the step
  /// before, with the impulses of its last substep.
  void find(World& world, const StepClassifier& before, const Plan& plan, Real dt);
  /// Adds the contacts of pairs that are as near as the `ways` of both, m, and have none yet. `wanted(a, b)`: whether to look at this pair.
  /// Returns whether it has added any.
  bool add_near(const World& world, const std::vector<Real>& ways,
                const std::function<bool(std::size_t, std::size_t)>& wanted);

 private:
  Contacts before_;
};

}  // namespace pushback
