/// The interface between a step and a solver.
#pragma once

#include <concepts>

#include "pushback/common/world/world.h"

namespace pushback {

/// A solver's plan of a step, with the numbers of detections and of velocity solves, and the workers to use.
struct Plan {
  int detections = 1;           ///< parts of the step; each begins by detecting contacts
  int substeps = 1;             ///< of each part; all have the same contacts
  int sweeps = 10;              ///< in each substep, unless the caller gives a number
  Margin margin = {};           ///< margin of each detection
  bool moves_bodies = false;    ///< whether `integrate_positions` moves them, if nothing reads their I^-1 in between
  Workers* workers = &alone();  ///< run work that can be divided

  int all_substeps() const { return detections * substeps; }
};

/// The number of rows of contacts and joints solved in the latest substep, and their largest residual, m/s.
struct SolveStats {
  int rows = 0;
  Real residual = 0;
};

/// A solver for World::step. Each part of a step calls `check` and `after_detection` once, `solve` and `after_move` in each of its
/// substeps, and `end_detection` at its end. The order is in step.h. Only `solve` has to be defined.
class StepSolver {
 public:
  StepSolver() = default;
  StepSolver(const StepSolver&) = default;
  StepSolver(StepSolver&&) = default;
  StepSolver& operator=(const StepSolver&) = default;
  StepSolver& operator=(StepSolver&&) = default;
  virtual ~StepSolver() = default;

  /// For a step of dt, s.
  virtual Plan plan(Real /*dt*/) const { return {}; }
  /// Whether the solver solves joints. If not, World::step refuses worlds with joints.
  virtual bool supports_joints() const { return false; }
  /// Throws InvalidInput if the solver cannot use a setting or something in this world. Called before the detection of each part,
  /// whose substeps take h, s.
  virtual void check(World&, Real /*h*/) {}
  /// Called after the contacts have been detected.
  virtual void after_detection(World&, Real /*h*/) {}
  /// Changes the velocities of bodies, and writes Contact::impulse and Contact::state of this substep for each contact. A solver
  /// with several substeps per detection may leave the writing to `end_detection`.
  virtual void solve(World& world, Real h, int sweeps) = 0;
  /// Moves all bodies by h v and h w, without refreshing their I^-1. Called only if the plan says `moves_bodies`, no
  /// force may turn a body, and there are no joints.
  virtual void integrate_positions(World& world, Real h);
  /// Called after the bodies have moved.
  virtual void after_move(World&, Real /*h*/) {}
  /// Called after the last substep of a part. With several substeps per detection, `end_detection` writes the impulse of the last
  /// substep to Contact::last_impulse and the sum over all substeps to Contact::impulse. With one substep, the step has already
  /// copied `impulse` to `last_impulse`. The step sums over the detections.
  virtual void end_detection(World&) {}
  /// A whole step of World::step, whose arguments have not been checked yet. Solvers that divide a world or a step in their own way
  /// override it. The default follows the order in step.h, which calls the functions above.
  virtual void whole_step(World& world, Real dt, int sweeps);
  /// For the latest substep. A solver without rows need not override it.
  virtual SolveStats stats() const { return {}; }
};

/// Whether this solver overrides `whole_step`.
template <class ContactSolver>
constexpr bool has_whole_step = !std::same_as<decltype(&ContactSolver::whole_step), decltype(&StepSolver::whole_step)>;

/// An effect that solves joints derives from this.
struct SupportsJoints {};

/// Throws InvalidInput if the world has joints and the solver does not solve joints.
void check_solvable(const World& world, const StepSolver& solver);

}  // namespace pushback
