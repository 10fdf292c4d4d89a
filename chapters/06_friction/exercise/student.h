/// Exercise 06: two tangent rows and their bound. The task is chapters/06_friction/exercise/task.md.
#pragma once

#include "pushback/chapters/06_friction/exercise/asked.h"

namespace student {

using namespace pushback;

/// Friction holds the contact point still, as far as the normal impulse lets it.
///
/// Of a contact   step.contacts[i]     point, normal, friction (μ of the pair)
///                step.rows[i]         its normal's row; step.rows[i].impulse is Σλn, N s, in this very sweep
///                tangents_of(normal)  two tangents: const auto [tangent1, tangent2] = tangents_of(...);
/// A new row      step.rows.emplace_back(step.world, step.contacts[i], direction, i);  It may move all rows in memory.
/// Of any row     speed() (J V, m/s), effective_mass (1 / K, kg), impulse (Σλ, N s)
/// and you call   row.reach(total)     brings Σλ to `total`, but no further than row.lo and row.hi
struct Rubbing : Effect {
  std::size_t first = 0;  // which row is the first tangent's, if you want to keep that

  // TODO build: two rows a contact. sweep, called in each sweep after the normals: each within its bound, J V = 0
  void build(StepContext& step) {
    (void)step;  // take this line out
  }
  void sweep(StepContext& step) {
    (void)step;  // take this line out
  }
  // TODO ends
};

inline const exercise_06::Answer answer{Rubbing{}};

}  // namespace student
