/// Moves the bodies that get substeps, while all others are fixed.
#pragma once

#include "pushback/engine/islands/island_settings.h"
#include "pushback/engine/substeps/wide_solver.h"

namespace pushback {

/// The number of detections in a step of dt (s) for bodies with an angular speed of up to `spin`, rad/s. Fast rotations need more than
/// one.
int detections(Real spin, const ClassifierLimits& limits, Real dt);

/// How the remaining bodies are moved in this step.
struct SubstepPass {
  WideSolver<Real>& solver;
  StepSolver& runner;  ///< passed to World::step: `solver`, or a solver that wraps it
  const IslandSettings& settings;
  Real dt;
  int sweeps;
};

class RemainingBodies {
 public:
  /// Moves immovable bodies, and all bodies that get substeps by `classifier`, by dt. Bodies that get another kind of step are fixed
  /// meanwhile, and their joints are left out. `found`: the contacts of this step, which are moved from. Faster rotations get more
  /// detections. Throws InvalidInput as World::step does.
  SolveStats step(World& world, const StepClassifier& classifier, Contacts& found, const SubstepPass& pass);

 private:
  class Absence;  // removes the joints and velocities of all other bodies for a while

  std::vector<Joint> joints_;                      // all joints of the world
  std::vector<std::size_t> lent_;                  // indices of the joints between remaining bodies
  std::vector<std::pair<Vec3, Vec3>> velocities_;  // of all bodies
};

}  // namespace pushback
