/// Joints in two stages: where their points are to be after the drift, and how they may move when it is over.
#pragma once

#include "pushback/chapters/18_direct_joints/joint_matrix.h"

namespace pushback {

/// The equations C(x, t) = 0 of all joints, solved directly (chapter 18), with one matrix for both stages:
///
///   velocities    J v + dC/dt = 0,     by impulses along J where the bodies are
///   positions     C = 0 after a drift of h s, by impulses along the same J, where the drift begins
///
/// So rows are placed once a step: where one drift ends, the next one begins.
class HeldJoints {
 public:
  /// Throws InvalidInput unless all equations hold, rigidly and in both directions. Of the step that begins.
  void check(const World& world);
  /// Asks all joints where the bodies are. What each row bears comes from World::joints, as the latest step left it.
  void begin(const World& world);
  /// C of all equations, where the bodies are, at this time (s). Returns the largest |C|.
  Real ask(const World& world, Real time);
  /// Rows where the last `ask` was, and A = J M^-1 J^T of the bodies' I^-1.
  void place(World& world, Real time, Real h);
  /// What the rows are expected to bear in half of h.
  void start(Real h);
  /// After the last `ask`:   A lambda = -C / h
  void press(Real h);
  /// The impulses since `start` have not acted.
  void take_back();
  /// A lambda = -(J v + dC/dt). `h`: of the step whose second half this is.
  void project(Real h);
  /// Joint::impulses: what acted since `begin`.
  void report(World& world) const;

  bool empty() const { return held_.empty(); }
  int rows() const { return static_cast<int>(rows_.size()); }
  /// The joint whose equation was off the most when last asked.
  std::size_t worst() const { return worst_; }

 private:
  void apply(const std::vector<double>& lambda);

  JointMatrix matrix_;
  JointRows rows_;
  Equations equations_, later_;
  std::vector<JointMatrix::Held> held_;
  std::vector<std::size_t> joints_;  // of each of held_, its index in the world
  std::vector<char> taken_;
  std::vector<double> lambda_;
  std::vector<Real> borne_;     // N, in the stage before; of each row
  std::vector<Real> in_stage_;  // N s, in this one
  std::vector<Real> total_;     // N s, since `begin`
  std::size_t worst_ = 0;
};

}  // namespace pushback
