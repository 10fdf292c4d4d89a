/// Chooses the number of half steps of an island by its energy error.
#pragma once

#include "pushback/engine/islands/island_settings.h"
#include "pushback/engine/islands/island_world.h"

namespace pushback {

/// The energy error of a step that did not converge.
inline constexpr Real infinite_error = std::numeric_limits<Real>::infinity();

/// The step that is being taken.
struct IslandStep {
  const World& whole;  ///< as the step begins
  const StepClassifier& classifier;
  const IslandSettings& settings;
  Real dt;  ///< s
};

/// The data of an island that are kept between steps, with its lowest body.
struct IslandMemory {
  int substeps = 0;       ///< half steps of the latest step
  int next_substeps = 0;  ///< half steps of the next step
  int steps_to_wait = 0;  ///< steps until half steps are tried again
  int failures = 0;       ///< consecutive ones, counted if joined bodies are near others, or contacts are many
};

/// Moves the island's copy in `substeps` half steps from the present state of its bodies in the whole world. If only gravity and rigid
/// joints act, the energy E = T + U is constant, and
///
///   energy_error = |dE| / (energy (T + m (h g)^2 / 2))      T: the larger value of before and after,  m: mass of the island
///
/// The energy that impacts dissipate is known and is no error. The energy that friction dissipates is unknown, so if contacts are held,
/// only a gain counts. The push-out of an overlap may lift the island by no more than the overlap. If other forces act, energy_error
/// is 0, and if the step does not converge, it is infinite.
StepOutcome try_half_steps(IslandWorld& island, const IslandStep& step, int substeps);

/// Doubles the number of half steps of the island until its energy error is at most 1. If the error is below an eighth, the next step
/// begins with half as many. Sets `island.moved` if the island has been moved.
void control_by_energy(IslandWorld& island, IslandMemory& memory, const IslandStep& step);

/// Takes the half steps that IslandSettings::given demands, and more if the energy error of joined bodies needs them. Sets `island.moved`
/// likewise.
void take_given_steps(IslandWorld& island, IslandMemory& memory, const IslandStep& step);

/// The maximum number of half steps of the island.
int most_half_steps(const IslandWorld& island, const IslandStep& step);

/// Whether the rest of `most_work` is enough for twice as many half steps. All tries for joined bodies with contacts share it.
inline bool can_double(const IslandWorld& island, const StepOutcome& outcome) {
  return !island.has_joints_and_may_touch() || island.half_step.most_work > 2 * outcome.work;
}

}  // namespace pushback
