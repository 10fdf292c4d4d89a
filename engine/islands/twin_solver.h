/// An estimate of the position error, from a second, coarser simulation.
///
///   TwinSolver solver;
///   solver.error = 1e-3;  // m. Without it only the energy of each island is checked
///   world.step(solver, 1.0 / 60);
#pragma once

#include <limits>

#include "pushback/engine/half_step/body_state.h"
#include "pushback/engine/islands/island_solver.h"

namespace pushback {

/// The error of a body.
struct BodyError {
  StepType step_type = StepType::none;
  int substeps = 0;         ///< half steps or substeps of the latest step
  Real position_error = 0;  ///< m, the position error since the first step, or since `forget_errors`
  bool kept = true;         ///< whether the error is within TwinSolver::error
};

/// IslandSolver, with as many substeps as keep positions within `error` for a second. A copy of the world, the twin, is stepped as
/// well, in about a quarter of the substeps. It starts as a copy of the world and afterwards is reset only for lost bodies (see below).
/// So it differs from the world by the errors of all steps, as later impacts have enlarged them:
///
///   |x - x_twin| / 2 >= error of x
///
/// With r times as many substeps of order p, the difference is r^p - 1 times the error, which is 3 times for p = 1 and r = 4. The
/// relation may fail for a moment, when the difference passes through 0.
///
/// A step and the same step in two halves (chapter 27) begin at the same state. Unlike their difference, this one contains errors of
/// rotations, and the growth of errors from impact to impact. It does not contain errors that world and twin have in common. So the two
/// numbers of substeps have no common divisor, and the error of a body that stops within a half step is counted separately.
///
/// If the difference that is expected in half a second exceeds a tenth of `error`, the bodies of an island get about twice as many
/// substeps. A difference above `error` cannot be corrected, so more substeps would be wasted, and the bodies are reported as not
/// kept. If the difference exceeds `error` by far, the bodies are `lost`, and their twins are reset to their present states.
///
/// Changes that a program makes between two steps are made in the twin as well. A body whose position or velocity it sets has no
/// error then. If a program composes its own steps, as chapter 20's sleep does, the error is unknown.
class TwinSolver : public IslandSolver {
 public:
  /// The allowed position error after one second, m. If it is infinite, there is no twin.
  Real error = std::numeric_limits<Real>::infinity();

  void whole_step(World& world, Real dt, int sweeps) override;
  /// The error of a body, or a default BodyError if the latest step did not contain it.
  BodyError error_of(int body);
  /// Resets all errors to 0.
  void forget_errors() {
    twin_.bodies.clear();
    known_.clear();
  }

 private:
  struct Known {       // of a body
    BodyState after;   // the state after the latest step
    int level = 1;     // selects the numbers of substeps
    int unneeded = 0;  // steps in a row for which a lower level would have been enough
    Real begun = 0;    // s, the time at which its twin was last reset
    Real carried = 0;  // m, its error at that time
    Real place = 0;    // m
    Real soon = 0;     // m, half of the difference expected in half a second
    Real early = 0;    // m, the distance that a sliding body would lose if it stopped now
    Real stopped = 0;  // m, the distance that it has lost in all stops
    Real lost = -std::numeric_limits<Real>::infinity();  // s, the time at which it was last lost
    bool kept = true;
  };
  void begin(const World& world);
  void follow(const World& world);
  void give_steps(Real dt);
  void compare(const World& world, Real dt);
  void count_stops(const World& world, Real dt);
  void begin_again(const World& world, std::vector<bool> lost);

  World twin_;
  IslandSolver coarse_;
  std::vector<Known> known_;
};

}  // namespace pushback
