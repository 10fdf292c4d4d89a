/// The contacts of a step, which determine the islands.
#pragma once

#include <algorithm>
#include <functional>
#include <span>

#include "pushback/common/collision/margin.h"
#include "pushback/common/world/step_solver.h"

namespace pushback {

/// The feature id of a pair that is near but has no contact point.
inline constexpr std::uint32_t no_feature = std::numeric_limits<std::uint32_t>::max();

/// The contacts of two bodies, of which there is at least one.
using PairContacts = std::span<const Contact>;

/// Calls act(PairContacts) for each pair of bodies. Its contacts follow each other in `contacts`.
template <class Act>
void each_pair(PairContacts contacts, const Act& act) {
  while (!contacts.empty()) {
    const ContactId& id = contacts.front().id;
    const auto end = std::find_if(contacts.begin(), contacts.end(), [&id](const Contact& at) {
      return at.id.body_a != id.body_a || at.id.body_b != id.body_b;
    });
    const auto count = static_cast<std::size_t>(end - contacts.begin());
    act(contacts.first(count));
    contacts = contacts.subspan(count);
  }
}

class StepClassifier;

/// All contacts within the margin, ascending.
class StepContacts {
 public:
  Contacts found;

  /// Finds the contacts within the plan's margin. The margin depends only on the velocities of the centres, so for free bodies that
  /// rotate fast, contacts within the distance that their farthest points move are found as well, except for bodies that Fast moved in
  /// the previous step, which `before` has classified. World::contacts stays as the previous step left it, with the impulses of its
  /// last substep.
  void find(World& world, const StepClassifier& before, const Plan& plan, Real dt);
  /// Adds the contacts of pairs that have none yet and whose distance is at most the sum of both `ways`, m. `wanted(a, b)`: whether to
  /// consider this pair. Returns whether it has added any.
  bool add_near(const World& world, const std::vector<Real>& ways,
                const std::function<bool(std::size_t, std::size_t)>& wanted);

 private:
  Contacts before_;
};

}  // namespace pushback
