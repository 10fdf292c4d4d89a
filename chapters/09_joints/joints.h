/// What joints ask for becomes rows, and rows are all that a solver knows.
#pragma once

#include "chapters/02_clamping/clamping.h"
#include "common/input.h"
#include "common/world.h"

namespace pushback {

/// Rows of its own, made of World::joints: a row for each equation that a joint asks for, solved in every sweep.
///
///   J V + b + (beta / h) C = 0,   sum(lambda) in h [lo, hi]          the equation's limits are forces, the row's impulses
///
/// The feedback is that of an equality: it follows (1 - beta)^k (chapter 03). With beta = 0 joints drift apart.
struct Joints : Effect {
  Real beta = Real(0.2);  ///< of 0 ... 1: how much of C one step takes away

  /// World::step calls it before `solve`. Joints of which nothing can move, or is awake, ask for nothing.
  void hold(World& world, Real dt) {
    require_not_negative("beta of the joints", beta);
    world_ = &world;
    dt_ = dt;
    joint_rows_.clear();
    for (std::size_t i = 0; i < world.joints.size(); ++i) {
      const Joint& joint = world.joints[i];
      Body &a = body_at(joint.a), &b = body_at(joint.b);
      if (!acts_on(a) && !acts_on(b)) continue;
      equations_.clear();
      joint.ask(a, b, {world.time, dt}, equations_);
      for (const Equation& equation : equations_) {
        Row& row = joint_rows_.emplace_back(a, b, equation, static_cast<int>(i));
        row.separation = equation.error;
        row.bias = equation.bias + beta / dt * equation.error;
        row.lo = dt * equation.lo;
        row.hi = dt * equation.hi;
        row.softness = equation.softness;
        row.effective_mass /= 1 + row.softness * row.effective_mass;  // 1 / (K + gamma)
      }
    }
  }
  void sweep(Rows&) {
    for (Row& row : joint_rows_) row.solve();
    rows_solved += joint_rows_.size();
  }
  /// Only after an effect that relaxes (chapter 12): the same equations where the bodies are now, and C is not fed back.
  /// Springs stay as they were: what they add to the speeds is meant.
  void moved(Rows&) {
    auto row = joint_rows_.begin();
    while (row != joint_rows_.end()) {
      equations_.clear();
      world_->joints[static_cast<std::size_t>(row->contact)].ask(*row->a, *row->b, {world_->time, dt_}, equations_);
      for (const Equation& equation : equations_) {
        if (row->softness == 0) {
          row->act_as(equation);
          row->bias = equation.bias;
        }
        ++row;
      }
    }
  }
  /// Those of the latest step; Row::contact is the index of the joint.
  const Rows& joint_rows() const { return joint_rows_; }

 protected:
  Rows joint_rows_;

 private:
  static bool acts_on(const Body& body) { return body.movable() && !body.asleep; }
  Body& body_at(int index) { return index == the_world ? immovable_ : world_->bodies[static_cast<std::size_t>(index)]; }

  World* world_ = nullptr;  // of the step that is under way
  Real dt_ = 0;
  Body immovable_ = sphere(1, 1).fixed();
  Equations equations_;
};

}  // namespace pushback
