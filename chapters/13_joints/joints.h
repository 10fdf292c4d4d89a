/// Joints as an effect, in which each equation of a joint becomes a row.
#pragma once

#include "pushback/chapters/01_velocity_constraint/solver.h"
#include "pushback/chapters/13_joints/joint_row.h"
#include "pushback/common/basics/input.h"

namespace pushback {

/// Builds a row for each equation of each joint in World::joints, and solves these rows in every sweep.
///
///   J V + b + (beta / h) C = 0,   sum(lambda) in h [lo, hi]          lo, hi: the equation's limits, which are forces
///
/// The rows are equalities, so C decays as (1 - beta)^k over k steps (chapter 03). With beta = 0 joints drift apart.
/// A joint has no rows if each of its bodies is immovable or asleep.
struct Joints : Effect, SupportsJoints, UpdatesGeometry {
  Real beta = Real(0.2);  ///< 0 ... 1: the fraction of C that one step removes

  /// Evaluates all equations before the step changes anything, because Joint::ask may throw.
  void check(StepContext& step) {
    require_not_negative("beta of the joints", beta);
    ask(step);
  }
  void build(StepContext& step) {
    if (asked_.size() != acting(step.world)) ask(step);  // a body has woken, or `check` was not called
    joint_rows_.clear();
    auto equation = equations_.begin();
    for (const Asked& asked : asked_) {
      const Joint& joint = step.world.joints[asked.joint];
      for (; equation != equations_.begin() + asked.end; ++equation) {
        JointRow& row = joint_rows_.emplace_back(step.world.body(joint.a), step.world.body(joint.b), equation->jacobian,
                                                 asked.joint, equation->softness);
        row.separation = equation->error;
        row.bias = equation->bias + beta / step.dt * equation->error;
        row.lo = step.dt * equation->lo;
        row.hi = step.dt * equation->hi;
      }
    }
    asked_.clear();  // each evaluation serves one build
  }
  void sweep(StepContext&) {
    for (JointRow& row : joint_rows_) row.solve();
    rows_solved += joint_rows_.size();
  }
  /// Adds the impulses that the rows have applied since the last report to Joint::impulses.
  void report(StepContext& step) {
    each_row([&](JointRow& row, std::size_t n) {
      std::vector<Real>& impulses = step.world.joints[row.owner].impulses;
      if (n == impulses.size()) impulses.push_back(0);
      impulses[n] += row.impulse - std::exchange(row.reported, row.impulse);
    });
  }
  /// Called only by a solver that relaxes (chapter 12). Evaluates the equations for the current poses and does not feed back C.
  /// The rows of springs stay as they are, because the speed that they add is intended. The next substep starts from these
  /// poses, so `build` uses the same equations.
  void update_geometry(StepContext& step) {
    ask(step);
    for (std::size_t i = 0; i < joint_rows_.size(); ++i) {
      JointRow& row = joint_rows_[i];
      if (row.softness != 0) continue;
      row.place(equations_[i].jacobian);
      row.bias = equations_[i].bias;
    }
  }
  /// Restricts the rows to the joints whose element is true, by index in World::joints. Empty: all joints.
  void only(const std::vector<bool>& which) { only_ = which; }
  /// The rows of the latest step. Row::owner is the index of the joint.
  const JointRows& joint_rows() const { return joint_rows_; }

 protected:
  /// Calls `use(row, n)` for each row. n: the row's index within its joint.
  template <class Use>
  void each_row(const Use& use) {
    for (std::size_t i = 0, n = 0; i < joint_rows_.size(); ++i) {
      n = i > 0 && joint_rows_[i].owner == joint_rows_[i - 1].owner ? n + 1 : 0;
      use(joint_rows_[i], n);
    }
  }

  JointRows joint_rows_;

 private:
  struct Asked {
    std::size_t joint;
    std::ptrdiff_t end;  // of its equations in equations_
  };
  bool acts(const World& world, const Joint& joint) const {
    const auto moves = [](const Body& body) { return body.movable() && !body.asleep; };
    if (!only_.empty() && !only_[static_cast<std::size_t>(&joint - world.joints.data())]) return false;
    return moves(world.body(joint.a)) || moves(world.body(joint.b));
  }
  std::size_t acting(const World& world) const {
    return static_cast<std::size_t>(std::count_if(world.joints.begin(), world.joints.end(),
                                                  [&](const Joint& joint) { return acts(world, joint); }));
  }
  void ask(const StepContext& step) {
    asked_.clear();
    equations_.clear();
    for (std::size_t i = 0; i < step.world.joints.size(); ++i) {
      const Joint& joint = step.world.joints[i];
      if (!acts(step.world, joint)) continue;
      joint.ask(step.world.body(joint.a), step.world.body(joint.b), {step.world.time, step.dt}, equations_);
      asked_.push_back({i, std::ssize(equations_)});
    }
  }

  std::vector<Asked> asked_;
  Equations equations_;
  std::vector<bool> only_;
};

}  // namespace pushback
