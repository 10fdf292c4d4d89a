/// Friction stops the slip at a contact point, by an impulse that the normal impulse bounds.
#pragma once

#include "pushback/chapters/05_restitution/restitution.h"

namespace pushback {

/// Appends its rows in `build`, and solves them in `sweep`, after the normals, whose impulses bound them.
///
/// Two rows along the tangents, b = 0:   |sum(lambda_t)| <= mu sum(lambda_n),   each by itself (a pyramid)
struct Friction : Effect {
  void build(StepContext& step) {
    first_ = step.rows.size();
    mu_.clear();
    for (std::size_t i = 0; i < step.contacts.size(); ++i) {
      const Contact& at = step.contacts[i];
      if (at.friction == 0) continue;  // no rows, because no friction can act
      const auto [tangent1, tangent2] = tangents_of(at.normal);
      step.rows.emplace_back(step.world, at, tangent1, i);
      step.rows.emplace_back(step.world, at, tangent2, i);
      mu_.push_back(at.friction);
    }
  }
  /// The bound is mu times the normal impulse that this sweep has just found.
  void sweep(StepContext& step) {
    Row* tangent = step.rows.data() + first_;
    for (std::size_t i = 0; i < mu_.size(); ++i) {
      const Real bound = mu_[i] * step.rows[tangent->owner].impulse;
      for (int axis = 0; axis < 2; ++axis, ++tangent) {
        tangent->lo = -bound;
        tangent->hi = bound;
        tangent->reach(tangent->impulse - tangent->effective_mass * tangent->speed());  // b = 0
      }
    }
    rows_solved += 2 * mu_.size();
  }
  void report(StepContext& step) {
    for (std::size_t i = 0; i < mu_.size(); ++i) {
      const Row& first = step.rows[first_ + 2 * i];
      const Row& second = step.rows[first_ + 2 * i + 1];
      const bool held = std::abs(first.impulse) < first.hi && std::abs(second.impulse) < second.hi;
      step.contacts[first.owner].state = held ? ContactState::sticking : ContactState::sliding;
    }
  }

 protected:
  std::size_t first_ = 0;  // index of the first tangent row, of two for each contact with friction
  std::vector<Real> mu_;   // of the contacts with friction, whose normals are rows[tangent.owner]
};

}  // namespace pushback
