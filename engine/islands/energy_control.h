/// As many half steps as the energy needs.
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

/// The memory of an island between steps, kept with its lowest body.
struct IslandMemory {
  int substeps = 0;  ///< half steps of the latest step
  int next = 0;      ///< half steps of the next step
  int waits = 0;     ///< steps until half steps are tried again
  int failures = 0;  ///< in a row, if joined bodies are near others, or contacts are many
};

/// Moves the island's copy in `substeps` half steps from where its bodies are in the whole world. If only gravity and rigid joints act, the
/// energy E = T + U is constant, and
///
///   energy_error = |dE| / (energy (T + m (h g)^2 / 2))      T: the larger one of before and after,  m: the island's mass
///
/// Impacts dissipate a known energy, which is no error. Friction dissipates an unknown one, so if contacts are held, only a gain counts.
/// Overlap that is resolved may lift the island by no more than itself. If other forces act, energy_error is 0, and if the step does not
/// converge, it is infinite.
StepOutcome try_half_steps(IslandWorld& island, const IslandStep& step, int substeps);

/// Doubles the half steps of the island until its energy error is at most 1. If that is below an eighth, the next step begins with half as
/// many. Sets `island.held` if the island has been moved.
void control_by_energy(IslandWorld& island, IslandMemory& memory, const IslandStep& step);

/// As many half steps as IslandSettings::given says, and more if the energy of joined bodies needs them. Sets `island.held` likewise.
void take_given_steps(IslandWorld& island, IslandMemory& memory, const IslandStep& step);

/// The most half steps that the island may get.
int most_half_steps(const IslandWorld& island, const IslandStep& step);

/// Whether the rest of `most_work` is enough for twice as many half steps. All tries for joined bodies with contacts share it.
inline bool can_double(const IslandWorld& island, const StepOutcome& outcome) {
  return !island.joined_and_near() || island.half_step.most_work > 2 * outcome.work;
}

}  // namespace pushback
