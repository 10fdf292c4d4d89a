/// What a step asks of a solver.
#pragma once

#include <concepts>

#include "pushback/common/world/world.h"

namespace pushback {

/// What a solver makes of a step: how often contacts are detected, how often velocities are solved, and by whom.
struct Plan {
  int detections = 1;           ///< so many parts of the step begin by detecting contacts
  int substeps = 1;             ///< of each part; contacts stay the same in all of them
  int sweeps = 10;              ///< in each substep, for who does not say how many
  Margin margin = {};           ///< how far ahead detection looks
  bool moves_bodies = false;    ///< whether `integrate_positions` moves them, where nothing reads their I^-1 in between
  Workers* workers = &alone();  ///< who does what falls into parts

  int all_substeps() const { return detections * substeps; }
};

/// How many rows of contacts and joints were solved in the latest substep, and how far the worst of them was from being
/// solved, m/s.
struct Solved {
  int rows = 0;
  Real residual = 0;
};

/// A solver, as World::step calls it: once in a part of the step `check` and `detected`, in each of the part's substeps
/// `solve` and `moved`, and `done` at the part's end. The order is in step.h. Only `solve` has to be defined.
class StepSolver {
 public:
  StepSolver() = default;
  StepSolver(const StepSolver&) = default;
  StepSolver(StepSolver&&) = default;
  StepSolver& operator=(const StepSolver&) = default;
  StepSolver& operator=(StepSolver&&) = default;
  virtual ~StepSolver() = default;

  /// Of a step of dt, s.
  virtual Plan plan(Real /*dt*/) const { return {}; }
  /// Whether it solves joints. If not, a world that has some is refused.
  virtual bool holds_joints() const { return false; }
  /// Throws InvalidInput if a setting, or what is in this world, cannot be used. Substeps will take h, s; nothing of them
  /// has been done yet.
  virtual void check(World&, Real /*h*/) {}
  /// The contacts have been detected.
  virtual void detected(World&, Real /*h*/) {}
  /// Changes the velocities of bodies, and says in Contact::impulse and Contact::state what it did at each contact in this
  /// substep. A solver with several substeps to a detection may leave that to `done`.
  virtual void solve(World& world, Real h, int sweeps) = 0;
  /// Moves all bodies on by h v and h w, but not their I^-1. Called where the plan says `moves_bodies`.
  virtual void integrate_positions(World& world, Real h);
  /// The bodies have moved.
  virtual void moved(World&, Real /*h*/) {}
  /// The last substep since the contacts were detected is over. With several substeps to a detection, `done` writes what the last
  /// one applied, Contact::last_impulse, and the sum over them all, Contact::impulse. With one, the step has made the former of the
  /// latter before it calls this. The step sums over the detections.
  virtual void done(World&) {}
  /// A whole step of World::step, whose arguments have not been checked yet. For who divides a world, or a step, in a way of its own;
  /// all others leave it to the order in step.h, which calls what stands above.
  virtual void whole_step(World& world, Real dt, int sweeps);
  /// Of the latest substep. A solver without rows has none to count.
  virtual Solved solved() const { return {}; }
};

/// Whether steps of this solver have an order of their own.
template <class ContactSolver>
constexpr bool has_whole_step = !std::same_as<decltype(&ContactSolver::whole_step), decltype(&StepSolver::whole_step)>;

/// An effect that solves joints derives from this.
struct HoldsJoints {};

/// Throws InvalidInput if there are joints in the world, and the solver does not hold them.
void check_solvable(const World& world, const StepSolver& solver);

}  // namespace pushback
