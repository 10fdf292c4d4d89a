/// Joints in two stages, for the positions after the drift and for the velocities at its end.
#pragma once

#include "pushback/engine/direct/joint_matrix.h"
#include "pushback/engine/half_step/newton_from_guess.h"

namespace pushback {

/// Rigid constraints, C(x, t) = 0, are solved directly (chapter 18), with one matrix for both stages:
///
///   velocities    J v + dC/dt = 0,     by impulses along J at the present positions
///   positions     C = 0 after a drift of h s, by impulses along the same J, at the start of the drift
///
/// So rows are built once per step, at the end of one drift, where the next one begins. The other kinds of equations are:
///
///   a limit       C >= 0, lambda >= 0, like a contact's gap. C + h J v >= 0, then J v >= 0 if it has been reached
///   a motor       |lambda| <= h/2 force in each stage. C + h (J v + dC/dt) = 0, then J v + dC/dt = 0, as far as the force allows
///   a spring      a force instead of a constraint, -k C - c J v, in both halves of the kick. The first half uses the velocity
///                 before it, and the second half the velocity after it. Backwards in time the two are exchanged
///
/// Limits, motors and dampers are solved together with all other rows, by NewtonFromGuess.
class HeldJoints {
 public:
  /// Throws InvalidInput if an equation is soft and has a limit. With `both_ways`, for steps that also go backwards in time, it also
  /// throws if an equation has a limit or damps.
  void check(const World& world, bool both_ways);
  /// Evaluates all joints at the present positions. The load of each row comes from World::joints, as the latest step left it.
  void begin(const World& world);
  /// Evaluates C of the rigid equations at the present positions and at this time (s). Returns the largest |C|.
  Real evaluate(const World& world, Real time);
  /// Builds the rows from the latest `evaluate` and the bodies' I^-1.
  void build_rows(World& world, Real time, Real h);
  /// Applies the first half of the spring impulses, by the velocities before it. Returns the reason if h is too long for a spring.
  std::string apply_springs_before_drift(const World& world, Real h);
  /// Applies the second half, for springs without damping.
  void apply_springs_after_drift(Real h);
  /// Applies the expected impulses of the rows in half of h.
  void warm_start(Real h);
  /// Solves the first stage for the C of the latest `evaluate`:   A lambda = -C / h
  void solve_positions(Real h);
  /// Solves the second stage of a step of h:   A lambda = -(J v + dC/dt)
  void solve_velocities(Real h);
  /// Ends the first stage and adds its impulses to the sums.
  void end_positions();
  /// Ends the second stage likewise. Its impulses become the expected impulses of the next step.
  void end_velocities(Real h);
  /// Adds to `newton` the rows of an impact at the present positions, for rigid equations and for limits that are reached.
  void add_impact_to(NewtonFromGuess& newton);
  /// Adds the impulses of the impact to the sums.
  void end_impact();
  /// Sets Joint::impulses and last_impulses to the sums since `begin`.
  void report(World& world) const;

  bool empty() const { return held_.empty(); }
  int rows() const { return static_cast<int>(rows_.size()); }
  /// Whether all equations are rigid or undamped springs, so that solves with A are enough.
  bool linear() const { return linear_; }
  /// The joint whose equation had the largest error at the latest evaluation.
  std::size_t worst() const { return worst_; }

  // ---- together with contacts -------------------------------------------------------------------------------------
  /// Sets bias and limits of limits and motors for the first stage of h, at the present positions.
  void prepare_positions(const World& world, Real time, Real h);
  /// Sets the bias of rigid equations so that J v + b = C / h, with the C of the latest `evaluate`.
  void prepare_rigid(Real h);
  /// Sets bias and limits of all equations for the second stage.
  void prepare_velocities(Real h);
  /// Adds the rows of the first or of the second stage to `newton`.
  void add_to(NewtonFromGuess& newton, bool second);

 private:
  enum class Kind { rigid, limit, motor, spring };
  struct HeldRow {  // of each row
    Kind kind;
    Real lo, hi;                      // N
    Real load = 0;                    // N, in the previous stage
    Real total = 0;                   // N s, since `begin`
    Real error_rate = 0;              // dC/dt, m/s
    Real stiffness = 0, damping = 0;  // k (N/m), c (N s/m)
    Real c = 0;                       // C of a spring or of a limit, m
    Real position_impulse = 0;        // N s, in the first stage
    bool active = true;               // for a limit: whether it is reached
    bool was_violated = false;        // for a limit: whether it was violated at the beginning of the step
  };
  void apply(const std::vector<double>& lambda);
  void solve(std::vector<double>& lambda);
  void find_springs(const World& world);
  /// Calls `act(held, equation, row)` for each row of this kind.
  template <class Act>
  void each(const World& world, const TimeStep& now, Kind kind, const Act& act);

  JointMatrix matrix_;
  bool factored_ = false;
  bool linear_ = true, springs_ = false;
  JointRows rows_;
  Equations equations_, evaluated_;
  std::vector<JointMatrix::JointBodies> joint_bodies_;
  std::vector<HeldRow> held_;
  std::vector<std::size_t> joints_;  // the index in the world of each element of joint_bodies_
  std::vector<char> in_matrix_;      // for each row, whether A contains it
  std::vector<double> lambda_;
  std::size_t worst_ = 0;
};

}  // namespace pushback
