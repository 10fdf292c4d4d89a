/// The bodies that substeps move, while all others stand still.
#pragma once

#include "pushback/engine/islands/island_settings.h"
#include "pushback/engine/substeps/wide_solver.h"

namespace pushback {

/// The detections in a step of dt, s, of bodies that turn by up to `spin`, rad/s: one, or more if that is fast.
int detections(Real spin, const ClassifierLimits& limits, Real dt);

/// How the remaining bodies are moved in this step.
struct SubstepPass {
  WideSolver<Real>& solver;
  StepSolver& runner;  ///< the same solver, or one around it, which World::step calls
  const IslandSettings& settings;
  Real dt;
  int sweeps;
};

class RemainingBodies {
 public:
  /// Moves immovable bodies, and all that `classifier` leaves to substeps, by dt. Bodies that get another step stand still meanwhile, and
  /// their joints are left out. `found`: the contacts of this step, which are used up. Faster spins get more detections. Throws
  /// InvalidInput as World::step does.
  SolveStats step(World& world, const StepClassifier& classifier, Contacts& found, const SubstepPass& pass);

 private:
  class Absence;  // of the joints and velocities of all other bodies

  std::vector<Joint> joints_;                      // of the world
  std::vector<std::size_t> lent_;                  // of these, the joints between remaining bodies
  std::vector<std::pair<Vec3, Vec3>> velocities_;  // of all bodies
};

}  // namespace pushback
