/// Joints in two stages: the position after the drift, and the velocity at its end.
#pragma once

#include "pushback/engine/direct/joint_matrix.h"
#include "pushback/engine/half_step/newton_from_guess.h"

namespace pushback {

/// Rigid constraints, C(x, t) = 0, are solved directly (chapter 18), with one matrix for both stages:
///
///   velocities    J v + dC/dt = 0,     by impulses along J at the present positions
///   positions     C = 0 after a drift of h s, by impulses along the same J, at the start of the drift
///
/// So rows are placed once per step, at the end of one drift, where the next one begins. The other kinds of equations are:
///
///   a limit       C >= 0, lambda >= 0, like a contact's gap. C + h J v >= 0, then J v >= 0 if it has been reached
///   a motor       |lambda| <= h/2 force in each stage. C + h (J v + dC/dt) = 0, then J v + dC/dt = 0, as far as that goes
///   a spring      a force instead of a constraint, -k C - c J v, in both halves of the kick. The first half uses the velocity
///                 before it, the second the velocity after it. Backwards in time the two are exchanged
///
/// Limits, motors and dampers are solved together with all other rows, by NewtonFromGuess.
class HeldJoints {
 public:
  /// Throws InvalidInput if an equation gives way and has a limit, and for `both_ways` in time also if one has a limit or damps.
  void check(const World& world, bool both_ways);
  /// Evaluates all joints at the present positions. The load of each row comes from World::joints, as the latest step left it.
  void begin(const World& world);
  /// C of the rigid equations at the present positions and at this time (s). Returns the largest |C|.
  Real ask(const World& world, Real time);
  /// Rows at the latest `ask`, from the bodies' I^-1.
  void place(World& world, Real time, Real h);
  /// The first half of the spring impulses, by the velocities before it. Returns the reason if h is too long for a spring.
  std::string pull(const World& world, Real h);
  /// The second half, for springs without damping.
  void pull_on(Real h);
  /// The expected impulses of the rows in half of h.
  void start(Real h);
  /// After the last `ask`:   A lambda = -C / h
  void press(Real h);
  /// A lambda = -(J v + dC/dt). `h`: the step whose second half this is.
  void project(Real h);
  /// Ends the first stage and adds its impulses to the sums.
  void pressed();
  /// Ends the second stage likewise. Its impulses are the expected ones of the next step.
  void projected(Real h);
  /// At an impact, where the rows are placed: the impulses of rigid equations, and of limits that are reached.
  void strike(NewtonFromGuess& newton);
  /// Adds its impulses to the sums.
  void struck();
  /// Joint::impulses and last_impulses: the sums since `begin`.
  void report(World& world) const;

  bool empty() const { return held_.empty(); }
  int rows() const { return static_cast<int>(rows_.size()); }
  /// Whether A is enough to solve them.
  bool linear() const { return linear_; }
  /// The joint whose equation had the largest error at the latest evaluation.
  std::size_t worst() const { return worst_; }

  // ---- together with contacts -------------------------------------------------------------------------------------
  /// Limits and motors for the first stage of h, at the present positions.
  void aim(const World& world, Real time, Real h);
  /// The rigid equations after the latest `ask`: J v + b = C / h.
  void aim_rigid(Real h);
  /// All equations for the second stage.
  void settle(Real h);
  /// The rows of the first or of the second stage.
  void add_to(NewtonFromGuess& newton, bool second);

 private:
  enum class Kind { rigid, limit, motor, spring };
  struct HeldRow {  // of each row
    Kind kind;
    Real lo, hi;                      // N
    Real borne = 0;                   // N, in the stage before
    Real total = 0;                   // N s, since `begin`
    Real moving = 0;                  // dC/dt, m/s
    Real stiffness = 0, damping = 0;  // k, N/m; c, N s/m
    Real c = 0;                       // C of a spring or of a limit, m
    Real pressing = 0;                // N s, in the first stage
    bool takes_part = true;           // a limit that is reached
    bool overlapped = false;          // one that was passed as the step began
  };
  void apply(const std::vector<double>& lambda);
  void solve(std::vector<double>& lambda);
  void find_springs(const World& world);
  /// `act(held, equation, row)` for each row of this kind.
  template <class Act>
  void each(const World& world, const TimeStep& now, Kind kind, const Act& act);

  JointMatrix matrix_;
  bool factored_ = false;
  bool linear_ = true, springs_ = false;
  JointRows rows_;
  Equations equations_, asked_;
  std::vector<JointMatrix::JointBodies> joints_held_;
  std::vector<HeldRow> held_;
  std::vector<std::size_t> joints_;  // of each of joints_held_, its index in the world
  std::vector<char> taken_;          // by A
  std::vector<double> lambda_;
  std::size_t worst_ = 0;
};

}  // namespace pushback
