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
  StepType how = StepType::none;
  int substeps = 0;  ///< half steps or substeps of the latest step
  Real place = 0;    ///< m: the position error since the first step, or since `forget_errors`
  bool kept = true;  ///< whether `error` allows it
};

/// IslandSolver, with as many substeps as keep positions within `error` for a second. A twin of the world is stepped as well, in
/// about a quarter of the substeps. It begins where the world begins, and is never made equal to it again. So it differs by
/// all errors of all steps, as later impacts have enlarged them:
///
///   |x - x_twin| / 2 >= error of x
///
/// With r times as many substeps of order p, the difference is r^p - 1 times the error: 3 times for p = 1 and r = 4. The relation may
/// fail for a moment, when the difference passes through 0.
///
/// Unlike the difference between a step and the same step in two halves (chapter 27), which both begin at the same state, this
/// contains errors of turns, and how errors grow from impact to impact. It does not contain errors that both make alike. So the
/// two numbers of substeps have no common divisor, and the error of a body that stops within a half step is counted by itself.
///
/// If the difference, with what its velocity makes of it in half a second, exceeds a tenth of `error`, the bodies of an island
/// get about twice as many substeps. A difference above `error` cannot be mended, so more substeps would be wasted. The bodies
/// are reported as not kept. Once they are `lost`, their twins begin again from where they are.
///
/// Whatever a program changes between two steps is changed in the twin. A body whose position or velocity it sets has no error
/// then. If it composes its steps itself, as chapter 20's sleep does, no error is known.
class TwinSolver : public IslandSolver {
 public:
  /// m: the allowed position error after one second. If it is infinite, there is no twin.
  Real error = std::numeric_limits<Real>::infinity();

  void whole_step(World& world, Real dt, int sweeps) override;
  /// Empty for a body that the step did not know.
  BodyError error_of(int body);
  /// Errors count from now on.
  void forget_errors() {
    twin_.bodies.clear();
    known_.clear();
  }

 private:
  struct Known {       // of a body
    BodyState after;   // the latest step
    int level = 1;     // of the numbers of substeps
    int unneeded = 0;  // steps in a row for which a lower level would have been enough
    Real begun = 0;    // s: when its twin was last made equal to it
    Real carried = 0;  // m: the error that was known then
    Real place = 0;    // m
    Real soon = 0;     // m: half of `expected` after it
    Real early = 0;    // m: the distance that it loses if it stops now, while it slides
    Real stopped = 0;  // m: the distance that it has lost in all stops
    Real lost = -std::numeric_limits<Real>::infinity();  // s: when it was last lost
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
