/// Joints in two stages: where their points are to be after the drift, and how they may move when it is over.
#pragma once

#include "pushback/engine/direct/joint_matrix.h"
#include "pushback/engine/half_step/newton_from_guess.h"

namespace pushback {

/// What holds rigidly, C(x, t) = 0, is solved directly (chapter 18), with one matrix for both stages:
///
///   velocities    J v + dC/dt = 0,     by impulses along J where the bodies are
///   positions     C = 0 after a drift of h s, by impulses along the same J, where the drift begins
///
/// So rows are placed once a step: where one drift ends, the next one begins. What else there is:
///
///   a limit       C >= 0, lambda >= 0: as a gap of contacts. C + h J v >= 0, then J v >= 0 where it has been reached
///   a motor       |lambda| <= h/2 force in each stage. C + h (J v + dC/dt) = 0, then J v + dC/dt = 0, as far as that goes
///   a spring      no constraint but a force, -k C - c J v, in both halves of the kick: the first from the velocity before it,
///                 the second from that after it. Backwards in time each is the other
///
/// Limits, motors and dampers have to be solved together with everything else, by NewtonFromGuess.
class HeldJoints {
 public:
  /// Throws InvalidInput where an equation gives way and has a limit; and, for `both_ways` in time, where one has a limit or damps.
  void check(const World& world, bool both_ways);
  /// Asks all joints where the bodies are. What each row bears comes from World::joints, as the latest step left it.
  void begin(const World& world);
  /// C of what holds rigidly, where the bodies are, at this time (s). Returns the largest |C|.
  Real ask(const World& world, Real time);
  /// Rows where the last `ask` was, of the bodies' I^-1.
  void place(World& world, Real time, Real h);
  /// The first half of what springs do, by the velocities before it. Returns why not, if h is too long for one.
  std::string pull(const World& world, Real h);
  /// The second, of those that do not damp.
  void pull_on(Real h);
  /// What the rows are expected to bear in half of h.
  void start(Real h);
  /// After the last `ask`:   A lambda = -C / h
  void press(Real h);
  /// A lambda = -(J v + dC/dt). `h`: of the step whose second half this is.
  void project(Real h);
  /// The first stage is over: its impulses count.
  void pressed();
  /// So is the second: and they are what is expected next.
  void projected(Real h);
  /// At an impact, where the rows are placed: what acts in no time. That is what holds rigidly, and limits that are reached.
  void strike(NewtonFromGuess& newton);
  /// Its impulses count.
  void struck();
  /// Joint::impulses and last_impulses: what acted since `begin`.
  void report(World& world) const;

  bool empty() const { return held_.empty(); }
  int rows() const { return static_cast<int>(rows_.size()); }
  /// Whether A alone solves them.
  bool linear() const { return linear_; }
  /// The joint whose equation was off the most when last asked.
  std::size_t worst() const { return worst_; }

  // ---- together with contacts -------------------------------------------------------------------------------------
  /// Limits and motors for the first stage of h, where the bodies are.
  void aim(const World& world, Real time, Real h);
  /// What holds rigidly, after the last `ask`: J v + b = C / h.
  void aim_rigid(Real h);
  /// All for the second.
  void settle(Real h);
  /// Of the first stage or of the second.
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
